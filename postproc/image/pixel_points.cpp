#include "postproc/image/pixel_points.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "lib/base/instruction_sets.h"
#include "lib/base/large_pages.h"
#include "lib/base/tolerance.h"

namespace gouge {
namespace {

// Returns every second bit of a number, joined.
std::uint32_t even_bits(std::uint32_t code) {
  code &= 0x55555555U;
  code = (code | (code >> 1)) & 0x33333333U;
  code = (code | (code >> 2)) & 0x0F0F0F0FU;
  code = (code | (code >> 4)) & 0x00FF00FFU;
  return (code | (code >> 8)) & 0x0000FFFFU;
}

/// A surface point for which a colour is computed: one for neighbouring pixels (2 x 2) that show one piece of surface.
struct PixelPoint {
  int x = 0, y = 0;  ///< it lies in the middle of this pixel, the first of those that it serves
  /// The pixels that it serves, within the square of 2 x 2 pixels that contains this one: bit x + 2 y.
  std::uint8_t covers = 0;
};

constexpr int kSide = 8;  // side of a square, in blocks of 2 x 2 pixels

/// A square of blocks of a picture that are examined together; it is given by its first block.
struct Square {
  int column = 0, row = 0;
};

// Returns the squares that cover a grid, in the order of Morton's curve: neighbours in the list are neighbours in the
// grid.
std::vector<Square> squares_of(int width, int height) {
  const int columns = (width + kSide - 1) / kSide, rows = (height + kSide - 1) / kSide;
  const auto side = std::bit_ceil(static_cast<std::uint32_t>(std::max({columns, rows, 1})));
  std::vector<Square> squares;
  for (std::uint64_t code = 0; code < static_cast<std::uint64_t>(side) * side; ++code) {
    const auto column = static_cast<int>(even_bits(static_cast<std::uint32_t>(code)));
    const auto row = static_cast<int>(even_bits(static_cast<std::uint32_t>(code >> 1)));
    if (column < columns && row < rows) squares.push_back({kSide * column, kSide * row});
  }
  return squares;
}

// Calls `at(column, row)` for every block of a square within the grid, in the order of the same curve.
template <class At>
void for_each_block(const Square& square, int width, int height, At&& at) {
  constexpr std::uint32_t kPlaces = kSide * kSide;
  static const auto places = [] {
    std::array<std::array<int, 2>, kPlaces> out{};
    for (std::uint32_t k = 0; k < kPlaces; ++k)
      out[k] = {static_cast<int>(even_bits(k)), static_cast<int>(even_bits(k >> 1))};
    return out;
  }();
  for (const auto& [x, y] : places) {
    if (square.column + x < width && square.row + y < height) at(square.column + x, square.row + y);
  }
}

// Returns the points of all pixels of the squares that show a face. Neighbours in the list are neighbours in the
// picture.
std::vector<PixelPoint> points_in(const SurfaceBuffer& buffer, const std::vector<Square>& squares) {
  std::vector<PixelPoint> points;
  points.reserve(squares.size() * kSide * kSide + 64);
  const View& view = buffer.view;
  const auto reach = static_cast<float>(4 * view.mm_per_pixel);
  const auto take = [&](int column, int row) {
    const std::size_t lead = buffer.index(2 * column, 2 * row);
    const float z = buffer.z[lead];
    const bool has_lead = buffer.face[lead] != kNoFace;
    std::uint8_t covers = 0;  // pixels for which the first pixel's point is used
    std::array<PixelPoint, 4> alone;
    std::size_t more = 0;
    for (int k = 0; k < 4; ++k) {
      const int x = 2 * column + k % 2, y = 2 * row + k / 2;
      if (x >= view.width || y >= view.height) continue;
      const std::size_t i = buffer.index(x, y);
      if (buffer.face[i] == kNoFace) continue;
      const auto bit = static_cast<std::uint8_t>(1U << static_cast<unsigned>(k));
      if (has_lead && (k == 0 || std::abs(z - buffer.z[i]) < reach))
        covers = static_cast<std::uint8_t>(covers | bit);
      else
        alone[more++] = {x, y, bit};
    }
    if (covers != 0) points.push_back({2 * column, 2 * row, covers});
    points.insert(points.end(), alone.begin(), alone.begin() + static_cast<std::ptrdiff_t>(more));
  };
  for (const Square& square : squares) for_each_block(square, (view.width + 1) / 2, (view.height + 1) / 2, take);
  return points;
}

std::vector<Square> squares_of(const View& view) { return squares_of((view.width + 1) / 2, (view.height + 1) / 2); }

/// Minimum and maximum depth of the surface in a square of a view; empty if it shows no surface.
struct Slab {
  float least = std::numeric_limits<float>::max(), most = std::numeric_limits<float>::lowest();
};

/// The slabs of all squares of a view, in the row order of its pixels.
class Slabs {
 public:
  explicit Slabs(const SurfaceBuffer& buffer)
      : columns_((buffer.view.width + kPixels - 1) / kPixels),
        slabs_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(buffer.view.height / kPixels + 1)) {
    // Each pixel of a row has a lane, so that a row of squares is examined at once.
    const auto padded = static_cast<std::size_t>(columns_ * kPixels),
               width = static_cast<std::size_t>(buffer.view.width);
    std::vector<float> least(padded), most(padded);
    for (int top = 0; top < buffer.view.height; top += kPixels) {
      std::ranges::fill(least, Slab{}.least);
      std::ranges::fill(most, Slab{}.most);
      for (int y = top; y < std::min(top + kPixels, buffer.view.height); ++y)
        widen(buffer.z.data() + buffer.index(0, y), least.data(), most.data(), width);
      for (int column = 0; column < columns_; ++column) {
        const auto first = std::ptrdiff_t{column} * kPixels;
        slabs_[index(column, top / kPixels)] = {
            *std::min_element(least.begin() + first, least.begin() + first + kPixels),
            *std::max_element(most.begin() + first, most.begin() + first + kPixels)};
      }
    }
  }
  [[nodiscard]] const Slab& of(const Square& square) const {
    return slabs_[index(square.column / kSide, square.row / kSide)];
  }

 private:
  static constexpr int kPixels = 2 * kSide;

  GOUGE_WIDE static void widen(const float* z, float* least, float* most, std::size_t count) {
    for (std::size_t x = 0; x < count; ++x) {
      const float high = most[x], low = least[x], here = z[x];
      most[x] = here > high ? here : high;
      const float seen = here > Slab{}.most ? here : low;
      least[x] = seen < low ? seen : low;
    }
  }
  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
  }

  int columns_;
  std::vector<Slab> slabs_;
};

/// Squares that are tested as balls with a common radius.
struct Balls {
  double radius_mm;
  std::vector<Vec3> centres{};
  std::vector<std::size_t> of{};  ///< the square of each ball
};

// Returns the squares where the field may be above 0. Each is tested as a ball about the surface in it. If that surface
// spans a large depth, at an edge of the part, a ball would be a poor bound, so the square is kept.
template <class Field>
std::vector<Square> squares_with(const Field& field, const SurfaceBuffer& buffer) {
  const View& view = buffer.view;
  const double half_mm = kSide * view.mm_per_pixel;
  // One radius is for faces seen from above or at an angle, the other for steep faces.
  std::array<Balls, 2> balls{Balls{1.75 * half_mm}, Balls{3 * half_mm}};
  const Slabs slabs(buffer);
  std::vector<Square> asked;
  std::vector<std::uint8_t> is_kept;
  for (const Square& square : squares_of(view)) {
    const Slab& slab = slabs.of(square);
    if (!(slab.least <= slab.most)) continue;
    const double least = static_cast<double>(slab.least), most = static_cast<double>(slab.most);
    const double half = Vec3(half_mm, half_mm, 0.5 * (most - least)).norm();
    const auto fitting = std::ranges::find_if(balls, [&](const Balls& some) { return half <= some.radius_mm; });
    if (fitting != balls.end()) {
      fitting->centres.push_back(
          view.unproject(2 * square.column + kSide, 2 * square.row + kSide, 0.5 * (least + most)));
      fitting->of.push_back(asked.size());
    }
    asked.push_back(square);
    is_kept.push_back(fitting == balls.end() ? 1 : 0);
  }
  for (const Balls& some : balls) {
    const std::vector<std::uint8_t> may_be =
        field.may_be_deep(some.centres, some.radius_mm * (1 + Tolerance::kRounding));
    for (std::size_t k = 0; k < some.of.size(); ++k) is_kept[some.of[k]] = may_be[k];
  }
  std::vector<Square> kept;
  for (std::size_t k = 0; k < asked.size(); ++k) {
    if (is_kept[k] != 0) kept.push_back(asked[k]);
  }
  return kept;
}

// Returns a value for every pixel from the values of the points; 0 where there is no surface. Empty if all are 0.
std::vector<float> spread(const SurfaceBuffer& buffer, const std::vector<PixelPoint>& points,
                          const std::vector<float>& values) {
  std::vector<float> out;
  for (std::size_t p = 0; p < points.size(); ++p) {
    if (!(values[p] > 0)) continue;
    if (out.empty()) {
      reserve_large(out, buffer.z.size());
      out.resize(buffer.z.size(), 0.0F);
    }
    const PixelPoint& point = points[p];
    for (int k = 0; k < 4; ++k) {
      if ((point.covers >> k & 1) != 0) out[buffer.index(point.x / 2 * 2 + k % 2, point.y / 2 * 2 + k / 2)] = values[p];
    }
  }
  return out;
}

}  // namespace

std::vector<float> depth_on_pixels(const DepthField& field, const PictureScene& scene, const SurfaceBuffer& buffer) {
  if (field.is_empty()) return {};
  const std::vector<PixelPoint> seen = points_in(buffer, squares_with(field, buffer));
  std::vector<FieldPoint> points;
  points.reserve(seen.size());
  for (const PixelPoint& p : seen) {
    const std::uint32_t face = buffer.face[buffer.index(p.x, p.y)];
    points.push_back({buffer.point(p.x, p.y), scene.against(face), scene.clearance_mm(face)});
  }
  return spread(buffer, seen, field.depth_at(points));
}

std::vector<float> overcut_on_pixels(const OvercutField& field, const PictureScene& scene,
                                     const SurfaceBuffer& buffer) {
  const std::vector<PixelPoint> seen = points_in(buffer, squares_with(field, buffer));
  std::vector<OvercutField::Ray> rays;
  rays.reserve(seen.size());
  for (const PixelPoint& p : seen) {
    const std::uint32_t face = buffer.face[buffer.index(p.x, p.y)];
    const Vec3 normal = scene.area_normal(face);
    const double length = normal.norm();
    rays.push_back(
        {buffer.point(p.x, p.y), length > 0 ? Vec3(-normal / length) : Vec3(-Vec3::UnitZ()), scene.mesh_of(face)});
  }
  return spread(buffer, seen, field.at(rays));
}

}  // namespace gouge

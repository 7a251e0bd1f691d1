#include "postproc/image/shade.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "lib/base/instruction_sets.h"
#include "lib/base/parallel.h"
#include "postproc/image/walk_line.h"

namespace gouge {
namespace {

struct Offset {
  int x, y;
};

// Two rings of neighbours, in pixels of a supersampled picture. Offsets are even, so that for every second pixel of
// every second row all neighbours are such pixels too.
constexpr std::array<Offset, 16> kNeighbours{{{6, 0},
                                              {4, 4},
                                              {0, 6},
                                              {-4, 4},
                                              {-6, 0},
                                              {-4, -4},
                                              {0, -6},
                                              {4, -4},
                                              {20, 8},
                                              {8, 20},
                                              {-8, 20},
                                              {-20, 8},
                                              {-20, -8},
                                              {-8, -20},
                                              {8, -20},
                                              {20, -8}}};
constexpr float kPerReach = 1.0F / 40;  // inverse of the distance in pixels up to which a surface hides the sky
constexpr int kBlock = 2;           // side in pixels of a block, which has one light if it shows one piece of surface
constexpr int kBorder = 10;         // maximum distance of a neighbour outside the picture, in blocks
constexpr float kNothing = -1e15F;  // depth of a block without surface
constexpr double kAlike = 0.998;    // cosine between faces that are so nearly in line that their light looks the same

Vec3 key_light() { return Vec3(-0.45, 0.75, 0.75).normalized(); }
Vec3 fill_light() { return Vec3(0.8, 0.1, 0.6).normalized(); }

/// The depth of the first pixel of every block, with an empty border.
class BlockDepths {
 public:
  explicit BlockDepths(const SurfaceBuffer& buffer)
      : columns((buffer.view.width + kBlock - 1) / kBlock),
        rows((buffer.view.height + kBlock - 1) / kBlock),
        stride_(columns + 2 * kBorder),
        z_(static_cast<std::size_t>(stride_) * static_cast<std::size_t>(rows + 2 * kBorder), kNothing) {
    for (int row = 0; row < rows; ++row) {
      float* const to = z_.data() + place(0, row);
      for (int column = 0; column < columns; ++column) {
        const std::size_t i = buffer.index(kBlock * column, kBlock * row);
        if (buffer.face[i] != kNoFace) to[column] = buffer.z[i];
      }
    }
  }
  [[nodiscard]] const float* at(int column, int row) const { return z_.data() + place(column, row); }
  [[nodiscard]] const float* neighbour(int column, int row, const Offset& o) const {
    return at(column + o.x / kBlock, row + o.y / kBlock);
  }

  int columns, rows;

 private:
  [[nodiscard]] std::size_t place(int column, int row) const {
    return static_cast<std::size_t>(row + kBorder) * static_cast<std::size_t>(stride_) +
           static_cast<std::size_t>(column + kBorder);
  }
  int stride_;
  std::vector<float> z_;
};

/// Values of a row of blocks, each in a list. Normals are in the frame of the view: x right, y down and z towards the
/// viewer. The other values are the share of the sky that the surroundings hide, 0 to 1, and the light.
struct LitBlocks {
  explicit LitBlocks(std::size_t count) : x(count), y(count), z(count), hidden(count), light(count) {}
  std::vector<float> x, y, z, hidden, light;

  /// Sets a normal of any length, on either side of the surface.
  void set(std::size_t at, const Eigen::Vector3f& right_up_toward) {
    x[at] = right_up_toward.x();
    y[at] = -right_up_toward.y();
    z[at] = right_up_toward.z();
  }
};

// Makes the normals unit vectors and turns them to the viewer.
GOUGE_WIDE void turn_to_viewer(LitBlocks& lit, std::size_t at, std::size_t count) {
  float* const x = lit.x.data() + at;
  float* const y = lit.y.data() + at;
  float* const z = lit.z.data() + at;
  for (std::size_t i = 0; i < count; ++i) {
    const float length = std::sqrt(x[i] * x[i] + y[i] * y[i] + z[i] * z[i]);
    const bool has_length = length > 0;
    const float per_length = (z[i] < 0 ? -1.0F : 1.0F) / (has_length ? length : 1.0F);
    x[i] = has_length ? x[i] * per_length : 0.0F;
    y[i] = has_length ? y[i] * per_length : 0.0F;
    z[i] = has_length ? z[i] * per_length : 1.0F;
  }
}

constexpr float kRise = 0.12F;         // a surface that rises less over another one hides none of its sky
constexpr std::size_t kTogether = 32;  // number of blocks tested at once, because usually none of them is hidden
// squares of slightly wider limits than kRise and kPerReach
constexpr float kMinRiseSquare = 0.0143F, kMaxReachSquare = 1601.0F;

// Adds the share of the sky that one neighbour hides for each of `count` blocks from `at` on.
GOUGE_WIDE void add_hidden(const float* z, const float* neighbour, const Offset& o, float per_mm, LitBlocks& lit,
                           std::size_t at, std::size_t count) {
  const auto ox = static_cast<float>(o.x), oy = static_cast<float>(o.y), across = ox * ox + oy * oy;
  const float* const nx = lit.x.data() + at;
  const float* const ny = lit.y.data() + at;
  const float* const nz = lit.z.data() + at;
  float* const hidden = lit.hidden.data() + at;
  for (std::size_t first = 0; first < count; first += kTogether) {
    const std::size_t last = std::min(first + kTogether, count);
    int may_hide = 0;
    for (std::size_t i = first; i < last; ++i) {
      const float dz = (neighbour[i] - z[i]) * per_mm;
      const float square = across + dz * dz;
      const float rise = ox * nx[i] + oy * ny[i] + dz * nz[i];
      may_hide |= static_cast<int>(rise > 0) & static_cast<int>(rise * rise > kMinRiseSquare * square) &
                  static_cast<int>(square < kMaxReachSquare);
    }
    if (may_hide == 0) continue;
    for (std::size_t i = first; i < last; ++i) {
      const float dz = (neighbour[i] - z[i]) * per_mm;
      const float length = std::sqrt(across + dz * dz);
      const float rise = (ox * nx[i] + oy * ny[i] + dz * nz[i]) / length - kRise;
      const float near = 1 - length * kPerReach;
      hidden[i] += (rise > 0 ? rise : 0) * (near > 0 ? near : 0);
    }
  }
}

// Computes light_on reduced by the share that the surroundings hide, which makes corners and grooves visible.
GOUGE_WIDE void find_light(LitBlocks& lit, std::size_t at, std::size_t count) {
  const Eigen::Vector3f key = key_light().cast<float>(), fill = fill_light().cast<float>();
  const float* const x = lit.x.data() + at;
  const float* const y = lit.y.data() + at;
  const float* const z = lit.z.data() + at;
  const float* const hidden = lit.hidden.data() + at;
  float* const light = lit.light.data() + at;
  for (std::size_t i = 0; i < count; ++i) {
    const float from_key = x[i] * key.x() - y[i] * key.y() + z[i] * key.z();
    const float from_fill = x[i] * fill.x() - y[i] * fill.y() + z[i] * fill.z();
    const float lit_by = 0.44F + 0.50F * (from_key > 0 ? from_key : 0) + 0.16F * (from_fill > 0 ? from_fill : 0);
    const float share = hidden[i] / 5;
    light[i] = lit_by * (1 - 0.55F * (share < 1 ? share : 1));
  }
}

// Computes the light of `count` blocks from (column, row) on, whose normals begin at `at`. `z` has the depths of the
// blocks.
void light_blocks(const BlockDepths& blocks, int column, int row, const float* z, float per_mm, LitBlocks& lit,
                  std::size_t at, std::size_t count) {
  turn_to_viewer(lit, at, count);
  std::fill_n(lit.hidden.data() + at, count, 0.0F);
  for (const Offset& o : kNeighbours) add_hidden(z, blocks.neighbour(column, row, o), o, per_mm, lit, at, count);
  find_light(lit, at, count);
}

void put(std::uint8_t* pixel, const Colour& colour, double light) {
  const std::array<unsigned char, 3> parts{colour.r, colour.g, colour.b};
  for (std::size_t k = 0; k < 3; ++k) pixel[k] = colour_level(std::clamp(parts[k] * light, 0.0, 255.0));
}

/// A painter of the rows of a picture, one row of blocks at a time.
class Shader {
 public:
  Shader(const PictureScene& scene, const SurfaceBuffer& buffer, const std::vector<float>& depth_mm,
         const ColourScale& scale, const BlockDepths& blocks)
      : scene_(scene),
        buffer_(buffer),
        depth_mm_(depth_mm),
        scale_(scale),
        blocks_(blocks),
        normals_at_(scene, buffer.view),
        lit_(static_cast<std::size_t>(blocks.columns)),
        one_(1) {}

  void paint(Raster& raster, int row) {
    const int y = kBlock * row;
    int first = blocks_.columns, last = 0;  // range of columns with surface
    const std::uint32_t* const faces = buffer_.face.data() + buffer_.index(0, y);
    for (int column = 0; column < blocks_.columns; ++column) {
      const std::uint32_t face = faces[kBlock * column];
      if (face == kNoFace) continue;
      lit_.set(static_cast<std::size_t>(column), normals_at_.in_view(face, kBlock * column, y));
      first = std::min(first, column);
      last = column + 1;
    }
    if (first < last)
      light_blocks(blocks_, first, row, blocks_.at(first, row), per_mm(), lit_, static_cast<std::size_t>(first),
                   static_cast<std::size_t>(last - first));
    paint_blocks(raster, row);
  }

 private:
  [[nodiscard]] float per_mm() const { return static_cast<float>(1 / buffer_.view.mm_per_pixel); }

  /// Returns whether two faces have the same light. Pixels of one face mostly follow each other, so the last result is
  /// kept.
  [[nodiscard]] bool is_alike(std::uint32_t face, std::uint32_t lead) {
    if (face == lead) return true;
    if (face != compared_face_ || lead != compared_lead_) {
      compared_face_ = face;
      compared_lead_ = lead;
      const bool is_one_kind = scene_.is_of_workpiece(face) == scene_.is_of_workpiece(lead);
      is_alike_ = is_one_kind && is_smooth_between(area_normal(face), area_normal(lead), kAlike);
    }
    return is_alike_;
  }

  /// Returns the normal of a face. Those of the faces in a row or two of the picture are kept.
  [[nodiscard]] const Vec3& area_normal(std::uint32_t face) {
    AreaNormal& known = area_normals_[face % area_normals_.size()];
    if (known.face != face) known = {face, scene_.area_normal(face)};
    return known.normal;
  }

  // Paints a row of blocks. Most blocks show one face and one depth and are painted here; paint_block paints the
  // others.
  void paint_blocks(Raster& raster, int row) {
    const int y = kBlock * row;
    const bool is_whole = y + 1 < raster.height;
    const std::size_t first = buffer_.index(0, y), width = static_cast<std::size_t>(raster.width);
    const std::uint32_t* const above = buffer_.face.data() + first;
    const std::uint32_t* const below = above + (is_whole ? width : 0);
    const float* const depth_above = depth_mm_.empty() ? nullptr : depth_mm_.data() + first;
    const float* const depth_below = depth_mm_.empty() ? nullptr : depth_above + (is_whole ? width : 0);
    const float* const light = lit_.light.data();
    std::uint8_t* const pixels_above = raster.pixel(0, y);
    std::uint8_t* const pixels_below = pixels_above + (is_whole ? 3 * width : 0);
    for (std::size_t column = 0; column < lit_.light.size(); ++column) {
      const std::size_t x = static_cast<std::size_t>(kBlock) * column;
      const bool is_inside = is_whole && x + 1 < width;
      const std::uint32_t lead = above[x];
      const bool is_one_face = is_inside && ((above[x + 1] ^ lead) | (below[x] ^ lead) | (below[x + 1] ^ lead)) == 0;
      if (is_one_face && lead == kNoFace) continue;
      if (!is_inside || lead == kNoFace || !(is_one_face || is_one_surface(lead, above + x + 1, below + x)) ||
          (depth_above != nullptr && !is_one_depth(depth_above + x, depth_below + x))) {
        paint_block(raster, static_cast<int>(column), row);
        continue;
      }
      std::uint8_t* const at = pixels_above + 3 * x;
      std::uint8_t* const under = pixels_below + 3 * x;
      colour(at, lead, depth_above == nullptr ? 0.0F : depth_above[x], static_cast<double>(light[column]));
      for (std::size_t k = 0; k < 3; ++k) at[3 + k] = under[k] = under[3 + k] = at[k];
    }
  }

  [[nodiscard]] bool is_one_surface(std::uint32_t lead, const std::uint32_t* beside, const std::uint32_t* below) {
    for (const std::uint32_t face : {beside[0], below[0], below[1]}) {
      if (face != lead && (face == kNoFace || !is_alike(face, lead))) return false;
    }
    return true;
  }

  static bool is_one_depth(const float* above, const float* below) {
    const auto [least, most] = std::minmax({above[0], above[1], below[0], below[1]});
    return !(least < most);
  }

  void paint_block(Raster& raster, int column, int row) {
    const int x = kBlock * column, y = kBlock * row;
    const std::uint32_t lead = buffer_.face[buffer_.index(x, y)];
    const double lead_light = static_cast<double>(lit_.light[static_cast<std::size_t>(column)]);
    for (int v = y; v < std::min(y + kBlock, raster.height); ++v) {
      for (int u = x; u < std::min(x + kBlock, raster.width); ++u) {
        const std::size_t i = buffer_.index(u, v);
        const std::uint32_t face = buffer_.face[i];
        if (face == kNoFace) continue;
        const float depth = depth_mm_.empty() ? 0.0F : depth_mm_[i];
        if (lead != kNoFace && is_alike(face, lead)) {
          colour(raster.pixel(u, v), face, depth, lead_light);
          continue;
        }
        one_.set(0, normals_at_.in_view(face, u, v));
        light_blocks(blocks_, column, row, &buffer_.z[i], per_mm(), one_, 0, 1);
        colour(raster.pixel(u, v), face, depth, static_cast<double>(one_.light[0]));
      }
    }
  }

  void colour(std::uint8_t* pixel, std::uint32_t face, float depth_mm, double light) const {
    // Gouges have less contrast, so that their colour is comparable with the colour bar everywhere.
    if (depth_mm > 0 || depth_mm < 0) return put(pixel, scale_.at(static_cast<double>(depth_mm)), 0.55 + 0.42 * light);
    put(pixel, scene_.is_of_workpiece(face) ? kPartGrey : kFixtureGrey, 0.12 + 0.97 * light);
  }

  const PictureScene& scene_;
  const SurfaceBuffer& buffer_;
  const std::vector<float>& depth_mm_;
  const ColourScale& scale_;
  const BlockDepths& blocks_;
  NormalsAt normals_at_;
  LitBlocks lit_, one_;
  struct AreaNormal {
    std::uint32_t face = kNoFace;
    Vec3 normal = Vec3::Zero();
  };
  std::vector<AreaNormal> area_normals_ = std::vector<AreaNormal>(512);
  std::uint32_t compared_face_ = kNoFace, compared_lead_ = kNoFace;
  bool is_alike_ = false;
};

void draw_edge(Raster& raster, const SurfaceBuffer& buffer, const Vec3& a, const Vec3& b) {
  const double slack = 2.5 * buffer.view.mm_per_pixel;
  walk_two_wide(a, b, raster.width, raster.height, [&](const Vec3& p, int x, int y) {
    if (p.z() + slack < static_cast<double>(buffer.z[buffer.index(x, y)])) return;
    blend_pixel(raster, x, y, {40, 48, 58, 1}, 0.28);
  });
}

}  // namespace

double light_on(double right, double up, double toward) {
  static const Vec3 key = key_light(), fill = fill_light();
  const Vec3 normal(right, up, toward);
  return 0.44 + 0.50 * std::max(0.0, normal.dot(key)) + 0.16 * std::max(0.0, normal.dot(fill));
}

void blend_pixel(Raster& raster, int x, int y, const Colour& colour, double opacity) {
  Coat(colour, opacity).lay(raster.pixel(x, y));
}

Raster shade(const PictureScene& scene, const SurfaceBuffer& buffer, const std::vector<float>& depth_mm,
             const ColourScale& scale) {
  Raster raster(buffer.view.width, buffer.view.height, 255, 255, 255);
  const BlockDepths blocks(buffer);
  for_each_chunk(static_cast<std::size_t>(blocks.rows), 32, 0, [&](std::size_t first, std::size_t last) {
    Shader shader(scene, buffer, depth_mm, scale, blocks);
    for (std::size_t row = first; row < last; ++row) shader.paint(raster, static_cast<int>(row));
  });
  for (const PictureScene::Edge& edge : scene.edges()) {
    draw_edge(raster, buffer, buffer.view.project(scene.vertex(edge.a)), buffer.view.project(scene.vertex(edge.b)));
  }
  return raster;
}

}  // namespace gouge

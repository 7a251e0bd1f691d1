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

// Two rings of neighbours, in pixels of a supersampled picture; even, so that every second pixel of every second row
// knows all of its own.
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
constexpr float kPerReach = 1.0F / 40;  // of the pixels that what hides the sky may be away
constexpr int kBlock = 2;               // pixels a side that share a light where they show one piece of surface
constexpr int kBorder = 10;             // blocks a neighbour may be outside the picture
constexpr float kNothing = -1e15F;      // as deep as where nothing is seen
constexpr double kAlike = 0.998;        // of faces so much in line no eye could tell the light apart

/// The depth of the first pixel of every block, with a border of nothing.
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

/// Normals as the view sees them: x right, y down, z towards the viewer.
struct ViewNormals {
  explicit ViewNormals(std::size_t count) : x(count), y(count), z(count), hidden(count) {}
  std::vector<float> x, y, z;
  std::vector<float> hidden;
};

// What one neighbour hides of the sky over each of `count` blocks, whose normals are those from `at` on.
GOUGE_WIDE void add_hidden(const float* z, const float* neighbour, const Offset& o, float per_mm, ViewNormals& n,
                           std::size_t at, std::size_t count) {
  const auto ox = static_cast<float>(o.x), oy = static_cast<float>(o.y), across = ox * ox + oy * oy;
  const float* const nx = n.x.data() + at;
  const float* const ny = n.y.data() + at;
  const float* const nz = n.z.data() + at;
  float* const hidden = n.hidden.data() + at;
  for (std::size_t i = 0; i < count; ++i) {
    const float dz = (neighbour[i] - z[i]) * per_mm;
    const float length = std::sqrt(across + dz * dz);
    const float rise = (ox * nx[i] + oy * ny[i] + dz * nz[i]) / length - 0.12F;
    const float near = 1 - length * kPerReach;
    hidden[i] += (rise > 0 ? rise : 0) * (near > 0 ? near : 0);
  }
}

// How much of the sky over `count` blocks from one on their surroundings hide, 0 to 1: corners and grooves get their
// depth from it. `z` are the blocks' own.
void find_hidden(const BlockDepths& blocks, int column, int row, const float* z, float per_mm, ViewNormals& n,
                 std::size_t at, std::size_t count) {
  std::fill_n(n.hidden.data() + at, count, 0.0F);
  for (const Offset& o : kNeighbours) add_hidden(z, blocks.neighbour(column, row, o), o, per_mm, n, at, count);
  for (std::size_t i = at; i < at + count; ++i) n.hidden[i] = std::min(1.0F, n.hidden[i] / 5);
}

std::uint8_t level(double value) { return static_cast<std::uint8_t>(value + 0.5); }

void put(std::uint8_t* pixel, const Colour& colour, double light) {
  const std::array<unsigned char, 3> parts{colour.r, colour.g, colour.b};
  for (std::size_t k = 0; k < 3; ++k) pixel[k] = level(std::clamp(parts[k] * light, 0.0, 255.0));
}

/// Paints the rows of a picture, a row of blocks at a time.
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
        normals_(static_cast<std::size_t>(blocks.columns)),
        one_(1) {}

  void paint(Raster& raster, int row) {
    const int y = kBlock * row;
    int first = blocks_.columns, last = 0;  // with surface
    for (int column = 0; column < blocks_.columns; ++column) {
      const std::size_t i = buffer_.index(kBlock * column, y);
      if (buffer_.face[i] == kNoFace) continue;
      set(normals_, static_cast<std::size_t>(column), buffer_.face[i], kBlock * column, y);
      first = std::min(first, column);
      last = column + 1;
    }
    if (first < last)
      find_hidden(blocks_, first, row, blocks_.at(first, row), per_mm(), normals_, static_cast<std::size_t>(first),
                  static_cast<std::size_t>(last - first));
    for (int column = 0; column < blocks_.columns; ++column) paint_block(raster, column, row);
  }

 private:
  [[nodiscard]] float per_mm() const { return static_cast<float>(1 / buffer_.view.mm_per_pixel); }

  void set(ViewNormals& n, std::size_t at, std::uint32_t face, int x, int y) {
    const View& view = buffer_.view;
    const Vec3 normal = normals_at_(face, x, y);
    n.x[at] = static_cast<float>(normal.dot(view.right));
    n.y[at] = static_cast<float>(-normal.dot(view.up));
    n.z[at] = static_cast<float>(normal.dot(view.toward));
  }

  [[nodiscard]] static double light(const ViewNormals& n, std::size_t i) {
    const double lit = light_on(static_cast<double>(n.x[i]), -static_cast<double>(n.y[i]), static_cast<double>(n.z[i]));
    return lit * (1 - 0.55 * static_cast<double>(n.hidden[i]));
  }

  /// Pixels of one face mostly follow each other, so the last answer is kept.
  [[nodiscard]] bool is_alike(std::uint32_t face, std::uint32_t lead) {
    if (face == lead) return true;
    if (face != compared_face_ || lead != compared_lead_) {
      compared_face_ = face;
      compared_lead_ = lead;
      const bool is_one_kind = scene_.is_fixture(face) == scene_.is_fixture(lead);
      is_alike_ = is_one_kind && is_smooth_between(scene_.area_normal(face), scene_.area_normal(lead), kAlike);
    }
    return is_alike_;
  }

  void paint_block(Raster& raster, int column, int row) {
    const std::size_t first = buffer_.index(kBlock * column, kBlock * row);
    const std::uint32_t lead = buffer_.face[first];
    const double lead_light = lead != kNoFace ? light(normals_, static_cast<std::size_t>(column)) : 0;
    const std::uint8_t* painted = nullptr;
    for (int y = kBlock * row; y < std::min(kBlock * row + kBlock, raster.height); ++y) {
      for (int x = kBlock * column; x < std::min(kBlock * column + kBlock, raster.width); ++x) {
        const std::size_t i = buffer_.index(x, y);
        const std::uint32_t face = buffer_.face[i];
        if (face == kNoFace) continue;
        std::uint8_t* const pixel = raster.pixel(x, y);
        if (lead != kNoFace && is_alike(face, lead)) {
          if (painted != nullptr && !(depth(i) < depth(first)) && !(depth(first) < depth(i))) {
            std::copy_n(painted, 3, pixel);
          } else {
            colour(pixel, i, lead_light);
            if (i == first) painted = pixel;
          }
          continue;
        }
        set(one_, 0, face, x, y);
        find_hidden(blocks_, column, row, &buffer_.z[i], per_mm(), one_, 0, 1);
        colour(pixel, i, light(one_, 0));
      }
    }
  }

  [[nodiscard]] double depth(std::size_t i) const {
    return depth_mm_.empty() ? 0.0 : static_cast<double>(depth_mm_[i]);
  }

  void colour(std::uint8_t* pixel, std::size_t i, double light) const {
    // Gouges with less contrast, so that a colour can be compared with the bar wherever it lies.
    if (depth(i) > 0) return put(pixel, scale_.at(depth(i)), 0.55 + 0.42 * light);
    put(pixel, scene_.is_fixture(buffer_.face[i]) ? kFixtureGrey : kPartGrey, 0.12 + 0.97 * light);
  }

  const PictureScene& scene_;
  const SurfaceBuffer& buffer_;
  const std::vector<float>& depth_mm_;
  const ColourScale& scale_;
  const BlockDepths& blocks_;
  NormalsAt normals_at_;
  ViewNormals normals_, one_;
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
  static const Vec3 key = Vec3(-0.45, 0.75, 0.75).normalized(), fill = Vec3(0.8, 0.1, 0.6).normalized();
  const Vec3 normal(right, up, toward);
  return 0.44 + 0.50 * std::max(0.0, normal.dot(key)) + 0.16 * std::max(0.0, normal.dot(fill));
}

void blend_pixel(Raster& raster, int x, int y, const Colour& colour, double opacity) {
  std::uint8_t* pixel = raster.pixel(x, y);
  const std::array<unsigned char, 3> parts{colour.r, colour.g, colour.b};
  for (std::size_t k = 0; k < 3; ++k) pixel[k] = level(pixel[k] * (1 - opacity) + parts[k] * opacity);
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

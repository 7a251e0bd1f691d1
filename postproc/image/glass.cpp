#include "postproc/image/glass.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "lib/base/parallel.h"
#include "postproc/image/shade.h"
#include "postproc/image/walk_line.h"

namespace gouge {
namespace {

constexpr int kHead = static_cast<int>(Body::head);

Colour glass_colour(const View& view, Vec3 normal, int body) {
  if (normal.dot(view.toward) < 0) normal = -normal;
  const double light =
      std::min(1.15, 0.25 + light_on(normal.dot(view.right), normal.dot(view.up), normal.dot(view.toward)));
  const Colour colour = body_colour(body);
  const auto lit = [&](unsigned char c) {
    return static_cast<unsigned char>(std::min(255.0, (0.35 * 255 + 0.65 * c) * light));
  };
  return {lit(colour.r), lit(colour.g), lit(colour.b), 1};
}

/// Pixels of a picture.
struct PixelRange {
  int left = 0, top = 0, right = 0, bottom = 0;  ///< the last two behind the last
};

/// What a view shows of these pixels alone.
View part_of(const View& view, const PixelRange& range) {
  View out = view;
  out.width = std::max(0, range.right - range.left);
  out.height = std::max(0, range.bottom - range.top);
  out.centre += (0.5 * (range.left + range.right - view.width) * view.mm_per_pixel) * view.right -
                (0.5 * (range.top + range.bottom - view.height) * view.mm_per_pixel) * view.up;
  return out;
}

/// The pane that a body lays over the part. It is drawn for some pixels of the picture; in no other is it seen.
class Pane {
 public:
  /// `body_of`: of a face.
  template <class BodyOf>
  Pane(const SurfaceBuffer& part, const PixelRange& range, SurfaceBuffer buffer, const BodyOf& body_of)
      : part_(part), range_(range), buffer_(std::move(buffer)), bodies_(buffer_.face.size(), std::int8_t{-1}) {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      if (buffer_.face[i] != kNoFace) bodies_[i] = static_cast<std::int8_t>(body_of(buffer_.face[i]));
    }
  }
  virtual ~Pane() = default;
  Pane(const Pane&) = delete;
  Pane& operator=(const Pane&) = delete;

  void paint(Raster& raster, int x, int y, NormalsAt& head_normals) const {
    const int body = body_at(x, y);
    const int right = x + 2 < raster.width ? body_at(x + 2, y) : body;
    const int below = y + 2 < raster.height ? body_at(x, y + 2) : body;
    const bool is_edge = right != body || below != body;
    if (body < 0 && !is_edge) return;
    const std::size_t i = part_.index(x, y);
    const bool is_hidden = body >= 0 && part_.face[i] != kNoFace && z_at(x, y) < part_.z[i];
    if (is_edge) {
      blend_pixel(raster, x, y, body_colour(std::max({body, right, below})), is_hidden ? 0.5 : 0.85);
      return;
    }
    blend_pixel(raster, x, y, colour(x, y, head_normals), is_hidden ? hidden_opacity() : opacity());
  }

  [[nodiscard]] float z_at(int x, int y) const {
    return is_within(x, y) ? buffer_.z[place(x, y)] : std::numeric_limits<float>::lowest();
  }
  [[nodiscard]] const SurfaceBuffer& buffer() const { return buffer_; }

 protected:
  /// Requires a face there.
  [[nodiscard]] std::uint32_t face_at(int x, int y) const { return buffer_.face[place(x, y)]; }

 private:
  [[nodiscard]] bool is_within(int x, int y) const {
    return x >= range_.left && y >= range_.top && x < range_.right && y < range_.bottom;
  }
  [[nodiscard]] std::size_t place(int x, int y) const { return buffer_.index(x - range_.left, y - range_.top); }
  [[nodiscard]] int body_at(int x, int y) const { return is_within(x, y) ? bodies_[place(x, y)] : -1; }
  [[nodiscard]] virtual Colour colour(int x, int y, NormalsAt& head_normals) const = 0;
  [[nodiscard]] virtual double opacity() const = 0;
  [[nodiscard]] virtual double hidden_opacity() const = 0;

  const SurfaceBuffer& part_;
  PixelRange range_;
  SurfaceBuffer buffer_;
  std::vector<std::int8_t> bodies_;  ///< by pixel of the range; -1: none
};

class ToolPane : public Pane {
 public:
  ToolPane(const SurfaceBuffer& part, const PixelRange& range, const ToolSurface& tool)
      : Pane(part, range, draw_surface(tool.vertices, tool.faces, part_of(part.view, range)),
             [&](std::uint32_t face) { return static_cast<int>(tool.bodies[face]); }),
        tool_(tool) {
    colours_.reserve(tool.faces.size());
    for (std::size_t f = 0; f < tool.faces.size(); ++f)
      colours_.push_back(glass_colour(part.view, normal(f), static_cast<int>(tool.bodies[f])));
  }

 private:
  [[nodiscard]] Vec3 normal(std::size_t face) const {
    const FaceCorners& corners = tool_.faces[face];
    const Vec3& a = tool_.vertices[corners[0]];
    const Vec3 square = (tool_.vertices[corners[1]] - a).cross(tool_.vertices[corners[2]] - a);
    return square.norm() < 1e-12 ? buffer().view.toward : Vec3(square.normalized());
  }
  [[nodiscard]] Colour colour(int x, int y, NormalsAt&) const override { return colours_[face_at(x, y)]; }
  [[nodiscard]] double opacity() const override { return 0.34; }
  [[nodiscard]] double hidden_opacity() const override { return 0.10; }

  const ToolSurface& tool_;
  std::vector<Colour> colours_;  ///< by face
};

/// Clearer than a tool: a head is large, and what it gouges lies behind it.
class HeadPane : public Pane {
 public:
  HeadPane(const SurfaceBuffer& part, const PictureScene& heads)
      : Pane(part, {0, 0, part.view.width, part.view.height}, draw_surface(heads, part.view),
             [](std::uint32_t) { return kHead; }) {}

 private:
  [[nodiscard]] Colour colour(int x, int y, NormalsAt& head_normals) const override {
    return glass_colour(buffer().view, head_normals(face_at(x, y), x, y), kHead);
  }
  [[nodiscard]] double opacity() const override { return 0.24; }
  [[nodiscard]] double hidden_opacity() const override { return 0.10; }
};

void draw_glass_edge(Raster& raster, const SurfaceBuffer& part, const SurfaceBuffer& head, const Vec3& a,
                     const Vec3& b) {
  const double slack = 2.5 * part.view.mm_per_pixel;
  walk_two_wide(a, b, raster.width, raster.height, [&](const Vec3& p, int x, int y) {
    const std::size_t i = head.index(x, y);
    const bool is_behind = p.z() + slack < static_cast<double>(head.z[i]);
    const bool is_hidden = p.z() + slack < static_cast<double>(part.z[i]);
    blend_pixel(raster, x, y, body_colour(kHead), (is_behind ? 0.22 : 0.7) * (is_hidden ? 0.55 : 1));
  });
}

/// The pixels that a tool may change: those it is seen in and, for its outline, two more.
PixelRange pixels_of(const ToolSurface& tool, const View& view) {
  constexpr double kFar = std::numeric_limits<double>::max();
  Vec2 low(kFar, kFar), high(-kFar, -kFar);
  for (const Vec3& vertex : tool.vertices) {
    const Vec3 p = view.project(vertex);
    low = low.cwiseMin(p.head<2>());
    high = high.cwiseMax(p.head<2>());
  }
  const auto clamped = [](double x, int most) {
    return static_cast<int>(std::clamp(x, 0.0, static_cast<double>(most)));
  };
  return {clamped(low.x() - 3, view.width), clamped(low.y() - 3, view.height), clamped(high.x() + 2, view.width),
          clamped(high.y() + 2, view.height)};
}

}  // namespace

void lay_glass(Raster& raster, const SurfaceBuffer& part, const ToolSurface& tool, const PictureScene& heads) {
  const PixelRange tool_range = pixels_of(tool, part.view);
  const ToolPane tool_pane(part, tool_range, tool);
  std::optional<HeadPane> head_pane;
  if (heads.face_count() > 0) head_pane.emplace(part, heads);
  const PixelRange range = head_pane ? PixelRange{0, 0, raster.width, raster.height} : tool_range;
  const auto rows = static_cast<std::size_t>(std::max(0, range.bottom - range.top));
  for_each_chunk(rows, 64, 0, [&](std::size_t first, std::size_t last) {
    NormalsAt head_normals(heads, part.view);
    for (int y = range.top + static_cast<int>(first); y < range.top + static_cast<int>(last); ++y) {
      for (int x = range.left; x < range.right; ++x) {
        const bool is_head_nearer = head_pane && head_pane->z_at(x, y) > tool_pane.z_at(x, y);
        if (head_pane && !is_head_nearer) head_pane->paint(raster, x, y, head_normals);
        tool_pane.paint(raster, x, y, head_normals);
        if (is_head_nearer) head_pane->paint(raster, x, y, head_normals);
      }
    }
  });
  for (const PictureScene::Edge& edge : heads.edges()) {
    draw_glass_edge(raster, part, head_pane->buffer(), part.view.project(heads.vertex(edge.a)),
                    part.view.project(heads.vertex(edge.b)));
  }
}

}  // namespace gouge

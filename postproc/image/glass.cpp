#include "postproc/image/glass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "lib/base/parallel.h"
#include "lib/base/tolerance.h"
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

/// A range of pixels of a picture.
struct PixelRange {
  int left = 0, top = 0, right = 0, bottom = 0;  ///< right and bottom are one past the last pixel
};

/// Returns the view restricted to these pixels.
View part_of(const View& view, const PixelRange& range) {
  View out = view;
  out.width = std::max(0, range.right - range.left);
  out.height = std::max(0, range.bottom - range.top);
  out.centre += (0.5 * (range.left + range.right - view.width) * view.mm_per_pixel) * view.right -
                (0.5 * (range.top + range.bottom - view.height) * view.mm_per_pixel) * view.up;
  return out;
}

constexpr int kOutline = 2;  // width in pixels of a supersampled picture

/// The transparent image of a body over the part. It is drawn only for the pixels of a range; outside, the body is not
/// visible.
class Pane {
 public:
  /// `body_of` returns the body of a face.
  template <class BodyOf>
  Pane(const SurfaceBuffer& part, const PixelRange& range, SurfaceBuffer buffer, const BodyOf& body_of)
      : part_(part), range_(range), buffer_(std::move(buffer)), stride_(buffer_.view.width + kOutline) {
    bodies_.assign(static_cast<std::size_t>(stride_) * static_cast<std::size_t>(buffer_.view.height + kOutline), -1);
    for (int y = 0; y < buffer_.view.height; ++y) {
      const std::uint32_t* const faces = buffer_.face.data() + buffer_.index(0, y);
      std::int8_t* const bodies = bodies_.data() + body_index(0, y);
      for (int x = 0; x < buffer_.view.width; ++x) {
        if (faces[x] != kNoFace) bodies[x] = static_cast<std::int8_t>(body_of(faces[x]));
      }
      // An outline does not run along the edge of the picture.
      if (range.right == part.view.width && buffer_.view.width >= kOutline)
        std::copy_n(bodies + buffer_.view.width - kOutline, kOutline, bodies + buffer_.view.width);
    }
    if (range.bottom != part.view.height || buffer_.view.height < kOutline) return;
    std::copy_n(bodies_.data() + body_index(0, buffer_.view.height - kOutline), kOutline * stride_,
                bodies_.data() + body_index(0, buffer_.view.height));
  }

  /// Paints a pixel. `coat_of(i, is_hidden)` returns the colour for pixel i of the buffer.
  template <class CoatOf>
  void paint(Raster& raster, int x, int y, const CoatOf& coat_of) const {
    if (!is_within(x, y)) return;
    const std::int8_t* const at = bodies_.data() + body_index(x - range_.left, y - range_.top);
    const int body = *at, right = at[kOutline], below = at[kOutline * stride_];
    const bool is_edge = right != body || below != body;
    if (body < 0 && !is_edge) return;
    const std::size_t i = place(x, y);
    const bool is_hidden = body >= 0 && buffer_.z[i] < part_.z[part_.index(x, y)];
    if (is_edge)
      Coat(body_colour(std::max({body, right, below})), is_hidden ? 0.5 : 0.85).lay(raster.pixel(x, y));
    else
      coat_of(i, is_hidden).lay(raster.pixel(x, y));
  }

  [[nodiscard]] float z_at(int x, int y) const {
    return is_within(x, y) ? buffer_.z[place(x, y)] : std::numeric_limits<float>::lowest();
  }
  [[nodiscard]] const SurfaceBuffer& buffer() const { return buffer_; }

 private:
  [[nodiscard]] bool is_within(int x, int y) const {
    return x >= range_.left && y >= range_.top && x < range_.right && y < range_.bottom;
  }
  [[nodiscard]] std::size_t place(int x, int y) const { return buffer_.index(x - range_.left, y - range_.top); }
  [[nodiscard]] std::size_t body_index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(stride_) + static_cast<std::size_t>(x);
  }

  const SurfaceBuffer& part_;
  PixelRange range_;
  SurfaceBuffer buffer_;
  int stride_;
  std::vector<std::int8_t> bodies_;  ///< for each pixel of the range and of a border behind it; -1: none
};

class ToolPane {
 public:
  ToolPane(const SurfaceBuffer& part, const PixelRange& range, const ToolSurface& tool)
      : pane_(part, range, draw_surface(tool.vertices, tool.faces, part_of(part.view, range)),
              [&](std::uint32_t face) { return static_cast<int>(tool.bodies[face]); }),
        tool_(tool) {
    coats_.reserve(tool.faces.size());
    for (std::size_t f = 0; f < tool.faces.size(); ++f) {
      const Colour colour = glass_colour(part.view, normal(f), static_cast<int>(tool.bodies[f]));
      coats_.push_back({Coat(colour, 0.34), Coat(colour, 0.10)});
    }
  }

  void paint(Raster& raster, int x, int y) const {
    pane_.paint(raster, x, y, [&](std::size_t i, bool is_hidden) -> const Coat& {
      return coats_[pane_.buffer().face[i]][is_hidden ? 1 : 0];
    });
  }
  [[nodiscard]] float z_at(int x, int y) const { return pane_.z_at(x, y); }

 private:
  [[nodiscard]] Vec3 normal(std::size_t face) const {
    const FaceCorners& corners = tool_.faces[face];
    const Vec3& a = tool_.vertices[corners[0]];
    const Vec3 square = (tool_.vertices[corners[1]] - a).cross(tool_.vertices[corners[2]] - a);
    return square.norm() < Tolerance::kNoDirection ? pane_.buffer().view.toward : Vec3(square.normalized());
  }

  Pane pane_;
  const ToolSurface& tool_;
  std::vector<std::array<Coat, 2>> coats_;  ///< for each face: if it is visible, and if it is behind the part
};

/// The pane of a head. It is more transparent than that of a tool, because a head is large and hides the surface that
/// it gouges.
class HeadPane {
 public:
  HeadPane(const SurfaceBuffer& part, const PictureScene& heads)
      : pane_(part, {0, 0, part.view.width, part.view.height}, draw_surface(heads, part.view),
              [](std::uint32_t) { return kHead; }) {}

  void paint(Raster& raster, int x, int y, NormalsAt& normals) const {
    pane_.paint(raster, x, y, [&](std::size_t i, bool is_hidden) {
      const SurfaceBuffer& buffer = pane_.buffer();
      return Coat(glass_colour(buffer.view, normals(buffer.face[i], x, y), kHead), is_hidden ? 0.10 : 0.24);
    });
  }
  [[nodiscard]] float z_at(int x, int y) const { return pane_.z_at(x, y); }
  [[nodiscard]] const SurfaceBuffer& buffer() const { return pane_.buffer(); }

 private:
  Pane pane_;
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

/// Returns the pixels that a tool may change: those in which it is visible, and two more for its outline.
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
        tool_pane.paint(raster, x, y);
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

#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "lib/base/large_pages.h"
#include "postproc/image/picture_scene.h"
#include "postproc/image/view.h"

namespace gouge {

inline constexpr std::uint32_t kNoFace = std::numeric_limits<std::uint32_t>::max();

/// The content of each pixel of a view: the nearest face and its depth (z-buffer).
struct SurfaceBuffer {
  View view;
  LargePageVector<float> z;             ///< mm towards the viewer; lowest float where there is no surface
  LargePageVector<std::uint32_t> face;  ///< index of the face; kNoFace where there is no surface

  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(view.width) + static_cast<std::size_t>(x);
  }
  /// Returns the surface point at the middle of the pixel. Requires a face there.
  [[nodiscard]] Vec3 point(int x, int y) const {
    return view.unproject(x + 0.5, y + 0.5, static_cast<double>(z[index(x, y)]));
  }
  [[nodiscard]] Vec3 point(std::size_t pixel) const {
    const auto width = static_cast<std::size_t>(view.width);
    return point(static_cast<int>(pixel % width), static_cast<int>(pixel / width));
  }
};

using FaceCorners = std::array<std::uint32_t, 3>;

/// Draws the triangles of a list of vertices into a buffer. At equal depth the face that is first in the list stays.
/// The result is the same with any number of threads.
[[nodiscard]] SurfaceBuffer draw_surface(const std::vector<Vec3>& vertices, const std::vector<FaceCorners>& faces,
                                         const View& view);
[[nodiscard]] SurfaceBuffer draw_surface(const PictureScene& scene, const View& view);

/// Interpolated normals of faces at the middles of pixels. They are computed quickly for pixels of one row after
/// another.
class NormalsAt {
 public:
  NormalsAt(const PictureScene& scene, const View& view) : scene_(scene), view_(view), kept_(kKept) {}
  /// Returns the unit normal, turned towards the viewer, in part coordinates.
  [[nodiscard]] Vec3 operator()(std::uint32_t face, int x, int y);
  /// Returns a normal of any length, on either side, as its components right, up and towards the viewer.
  [[nodiscard]] Eigen::Vector3f in_view(std::uint32_t face, int x, int y);

 private:
  struct Known {
    std::uint32_t face = kNoFace;
    /// Normal of the third corner in the frame of the view, and the differences of those of the first two corners from
    /// it.
    Eigen::Vector3f last = Eigen::Vector3f::Zero(), first_more = last, second_more = last;
    /// Shares of the first two corners: at the left top pixel, and their change for a pixel to the right and down.
    double u = 0, u_right = 0, u_down = 0, v = 0, v_right = 0, v_down = 0;
  };
  [[nodiscard]] Known know(std::uint32_t face) const;

  static constexpr std::size_t kKept = 1024;  // number of faces kept: those of a row or two of a picture

  const PictureScene& scene_;
  const View& view_;
  std::vector<Known> kept_;
};

/// Returns whether a surface point is within the view and not hidden behind another face.
[[nodiscard]] bool is_visible(const SurfaceBuffer& buffer, const Vec3& point_part, double slack_mm);

}  // namespace gouge

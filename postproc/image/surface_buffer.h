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

/// Content of each pixel of a view: the nearest face and how near (z-buffer).
struct SurfaceBuffer {
  View view;
  LargePageVector<float> z;             ///< mm towards the viewer; lowest float where nothing is seen
  LargePageVector<std::uint32_t> face;  ///< index, kNoFace where nothing is seen

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

/// Draws triangles given as corners into a buffer. At equal depth the face listed first stays.
/// The same at any number of threads.
[[nodiscard]] SurfaceBuffer draw_surface(const std::vector<Vec3>& vertices, const std::vector<FaceCorners>& faces,
                                         const View& view);
[[nodiscard]] SurfaceBuffer draw_surface(const PictureScene& scene, const View& view);

/// Interpolated normals of faces at the middles of pixels. Quick for pixels of one row after another.
class NormalsAt {
 public:
  NormalsAt(const PictureScene& scene, const View& view) : scene_(scene), view_(view), kept_(kKept) {}
  /// Returns the unit normal, turned towards the viewer, in part coordinates.
  [[nodiscard]] Vec3 operator()(std::uint32_t face, int x, int y);
  /// Returns a normal of any length and to either side, as its components right, up and towards the viewer.
  [[nodiscard]] Eigen::Vector3f in_view(std::uint32_t face, int x, int y);

 private:
  struct Known {
    std::uint32_t face = kNoFace;
    /// Normal of the third corner in_view, and what those of the others have more.
    Eigen::Vector3f last = Eigen::Vector3f::Zero(), first_more = last, second_more = last;
    /// Shares of the first two corners: at the left top pixel, and what they gain to the right and down.
    double u = 0, u_right = 0, u_down = 0, v = 0, v_right = 0, v_down = 0;
  };
  [[nodiscard]] Known know(std::uint32_t face) const;

  static constexpr std::size_t kKept = 1024;  // faces: those of a row or two of a picture

  const PictureScene& scene_;
  const View& view_;
  std::vector<Known> kept_;
};

/// Returns whether a surface point is seen and not hidden behind another face.
[[nodiscard]] bool is_visible(const SurfaceBuffer& buffer, const Vec3& point_part, double slack_mm);

}  // namespace gouge

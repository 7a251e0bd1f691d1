#pragma once

#include <span>
#include <vector>

#include "lib/field/checked_toolpath.h"
#include "lib/field/point_depths.h"
#include "lib/geom/pose.h"

namespace gouge {

/// Depth of the heads in the surface during the gouging moves of a path, sampled as a DepthField is.
/// A head is wide: it is sampled less often than a tool, and only where it comes near the surface. Of paths
/// with hundreds of moves whose heads gouge, the worst of each few neighbours are examined.
class HeadField {
 public:
  /// Picks the instants, about `max_poses` of them. `input` and what it points at must outlive it.
  HeadField(const CheckedToolpath& input, std::size_t max_poses);

  [[nodiscard]] bool is_empty() const { return swept_.empty(); }

  /// Raises the depth of each point to that in the heads where it counts as a gouge; mm, within 3 % of the sampled
  /// poses.
  void deepen(const std::vector<FieldPoint>& points, std::vector<float>& depth_mm) const;

  /// Raises that of each point above 0 where a ball of that radius about it may reach into a head so that it counts.
  void find_any(const std::vector<FieldPoint>& points, double radius_mm, std::vector<float>& found) const;

  /// A head at an instant.
  struct SweptPose {
    std::size_t head = 0;
    RigidTransform to_tool;  ///< from the part
  };
  [[nodiscard]] const std::vector<SweptPose>& all_swept() const { return swept_; }

 private:
  template <class Bodies>
  void raise(const std::vector<FieldPoint>& points, std::vector<float>& values, const Bodies& bodies_of) const;

  std::span<const HeadBody> heads_;
  std::vector<SweptPose> swept_;
  double tolerance_mm_ = 0;
};

}  // namespace gouge

#pragma once

#include <span>
#include <vector>

#include "lib/field/checked_toolpath.h"
#include "lib/field/point_depths.h"
#include "lib/geom/pose.h"

namespace gouge {

/// Depth of the heads in the surface during the gouging moves of a path, sampled in the same way as a DepthField. A
/// head is wide, so it is sampled less often than a tool, and only near the surface. If heads gouge in hundreds of
/// moves, only the worst of each few neighbours is examined.
class HeadField {
 public:
  /// Picks about `max_poses` instants. `input` and the objects it points to must outlive it.
  HeadField(const CheckedToolpath& input, std::size_t max_poses);

  [[nodiscard]] bool is_empty() const { return swept_.empty(); }

  /// Raises the depth of each point to its depth in the heads, if that counts as a gouge. Depths are in mm, within 3 %
  /// of the sampled poses.
  void deepen(const std::vector<FieldPoint>& points, std::vector<float>& depth_mm) const;

  /// Raises the value of a point above 0 if a ball of that radius about it may reach into a head far enough to count.
  void find_any(const std::vector<FieldPoint>& points, double radius_mm, std::vector<float>& found) const;

  /// A head at an instant.
  struct SweptPose {
    std::size_t head = 0;
    RigidTransform to_tool;  ///< from part coordinates to the tool's frame
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

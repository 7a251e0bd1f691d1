#pragma once

#include <cstdint>
#include <vector>

#include "lib/field/checked_toolpath.h"
#include "lib/field/head_field.h"
#include "lib/geom/pose.h"

namespace gouge {

/// Depth of the gouging moves of a path in the surface, at any point of it, for the tool and the heads. The depth is
/// sampled at many instants of each gouging move, including the worst one. It is for pictures and guarantees nothing.
class DepthField {
 public:
  using Point = FieldPoint;

  static constexpr std::size_t kMaxPoses = 12000;

  /// Picks the instants: about `max_poses` of them for the tool, and a twenty-fifth as many for the heads, whose
  /// distances cost more. The worst instant of every gouging move is included as long as there is room for all.
  explicit DepthField(const CheckedToolpath& input, std::size_t max_poses = kMaxPoses);

  /// Returns, for each point, the largest depth that counts as a gouge, in mm; otherwise 0. It is within 3 % of the
  /// sampled poses.
  [[nodiscard]] std::vector<float> depth_at(const std::vector<Point>& points) const;

  /// Returns, for each ball of that radius about a centre, whether any point in it may have a depth. If not, depth_at
  /// is 0 there. With `around_mm` it also returns true if any part of the tool may be within that distance of such a
  /// point.
  [[nodiscard]] std::vector<std::uint8_t> may_be_deep(const std::vector<Vec3>& centres, double radius_mm,
                                                      double around_mm = 0) const;

  [[nodiscard]] bool is_empty() const { return poses_.empty() && heads_.is_empty(); }

  struct FieldPose {
    Pose pose;
    const ToolVariants* tool = nullptr;
    std::size_t first_move = 0, last_move = 0;  ///< moves to which the instant belongs; two if it ends one and begins
                                                ///< the next
  };
  /// Returns the poses of the tool in path order.
  [[nodiscard]] const std::vector<FieldPose>& poses() const { return poses_; }
  [[nodiscard]] const HeadField& heads() const { return heads_; }
  /// Returns depth_at for the tool alone.
  [[nodiscard]] std::vector<float> tool_depth_at(const std::vector<Point>& points) const;

 private:
  std::vector<FieldPose> poses_;
  HeadField heads_;
  double tolerance_mm_ = 0, largest_clearance_mm_ = 0;  ///< the second is the largest clearance of a mesh
};

}  // namespace gouge

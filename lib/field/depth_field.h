#pragma once

#include <cstdint>
#include <vector>

#include "lib/field/checked_toolpath.h"
#include "lib/field/head_field.h"
#include "lib/geom/pose.h"

namespace gouge {

/// Depth of the gouging moves of a path in the surface, at any point of it: the tool and the heads.
/// The depth is sampled at many instants of each gouging move, the worst one among them; it is for pictures
/// and guarantees nothing.
class DepthField {
 public:
  using Point = FieldPoint;

  static constexpr std::size_t kMaxPoses = 12000;

  /// Picks the instants: about `max_poses` of them for the tool, and a twenty-fifth for the heads, whose distances cost
  /// more. The worst instant of every gouging move is among them as long as that many fit.
  explicit DepthField(const CheckedToolpath& input, std::size_t max_poses = kMaxPoses);

  /// Returns for each point the largest depth that counts as a gouge, in mm, else 0. Within 3 % of the sampled poses.
  [[nodiscard]] std::vector<float> depth_at(const std::vector<Point>& points) const;

  /// Returns for each ball of that radius about a centre whether any point in it may have a depth. Where not, no
  /// depth_at is more than 0. With `around_mm` also whether any of the tool may be within that of such a point, however
  /// little.
  [[nodiscard]] std::vector<std::uint8_t> may_be_deep(const std::vector<Vec3>& centres, double radius_mm,
                                                      double around_mm = 0) const;

  [[nodiscard]] bool is_empty() const { return poses_.empty() && heads_.is_empty(); }

  struct FieldPose {
    Pose pose;
    const ToolVariants* tool = nullptr;
    std::size_t first_move = 0, last_move = 0;  ///< it is an instant of; two where one ends and the next begins
  };
  /// Poses of the tool, in the order of the path.
  [[nodiscard]] const std::vector<FieldPose>& poses() const { return poses_; }
  [[nodiscard]] const HeadField& heads() const { return heads_; }
  /// Returns depth_at of the tool alone.
  [[nodiscard]] std::vector<float> tool_depth_at(const std::vector<Point>& points) const;

 private:
  std::vector<FieldPose> poses_;
  HeadField heads_;
  double tolerance_mm_ = 0, largest_clearance_mm_ = 0;  ///< the latter of a mesh
};

}  // namespace gouge

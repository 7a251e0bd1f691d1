#pragma once

#include "lib/head/head_body.h"
#include "lib/motion/body_motion.h"
#include "lib/overcut/swept_solid.h"

namespace gouge {

/// A body that hangs on the tool axis, along one motion.
class SweptHead : public SweptSolid {
 public:
  /// `head` must outlive this.
  SweptHead(const Motion& motion, const HeadBody& head);

  [[nodiscard]] double distance_at(const Vec3& point_part, double t) const override;
  [[nodiscard]] Vec3 outward_at(const Vec3& point_part, double t) const override;
  [[nodiscard]] std::uint32_t segments() const override { return intervals_.segments(); }
  std::uint32_t halve(std::uint32_t interval) override { return intervals_.halve(interval); }
  [[nodiscard]] SweptBound bound(const Vec3& centre, double radius_mm, std::uint32_t interval) const override;
  /// None where the head's surface over the cell is steep, or where the head goes on above it.
  [[nodiscard]] std::optional<DriftingHalfSpace> half_space(const Vec3& point, double s, const Vec3& centre,
                                                            double radius_mm, std::uint32_t interval) const override;
  [[nodiscard]] std::vector<Box3> extents(const Eigen::Matrix3d& frame, std::uint32_t interval,
                                          bool is_sharp_only) const override;

 private:
  const HeadBody& head_;
  BodyMotion moving_;
  IntervalTree<BodyInterval, BodyMotion> intervals_;
  Box3 box_;  // in the tool's frame
};

}  // namespace gouge

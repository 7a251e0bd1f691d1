#pragma once

#include "lib/head/head_body.h"
#include "lib/head/head_motion.h"
#include "lib/overcut/swept_solid.h"

namespace gouge {

/// A body that hangs on the tool axis, along one motion.
class SweptHead : public SweptSolid {
 public:
  /// `head` must outlive this.
  SweptHead(const Motion& motion, const HeadBody& head);

  [[nodiscard]] double distance_at(const Vec3& point_part, double t) const override;
  [[nodiscard]] Vec3 outward_at(const Vec3& point_part, double t) const override;

 private:
  [[nodiscard]] double reach_mm() const override { return reach_mm_; }
  [[nodiscard]] double turn_rad() const override { return moving_.turn_rad(); }

  const HeadBody& head_;
  HeadMotion moving_;
  double reach_mm_ = 0;
};

}  // namespace gouge

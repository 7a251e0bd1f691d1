#pragma once

#include "lib/motion/motion_law.h"

// Motions under the law of CL data: the axis moves on the great circle.

namespace gouge::test {

[[nodiscard]] inline Motion straight(const Pose& from, const Pose& to) { return MotionLaw().straight(from, to); }

[[nodiscard]] inline Motion dogleg(const Pose& from, const Pose& to) {
  return MotionLaw(RapidMode::dogleg).between(from, to, MoveKind::rapid);
}

/// Returns the motion along a curve: an arc or a spline.
template <typename Curve>
[[nodiscard]] Motion along(const Pose& from, const Pose& to, const Curve& curve) {
  return MotionLaw().along(from, to, curve);
}

}  // namespace gouge::test

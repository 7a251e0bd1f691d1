#pragma once

#include <vector>

#include "lib/check/check_options.h"
#include "lib/geom/pose.h"
#include "lib/path/toolpath.h"

// The motion of a move: tip linear in t, axis on the great circle with constant rate (CL-data meaning);
// in dogleg mode the tip follows the broken line of axes that all run at one speed until each arrives.

namespace gouge {

/// One stretch of a motion over [t0, t1] of the move: tip from `tip0` to `tip1`, linear.
struct TipStretch {
  double t0 = 0, t1 = 1;
  Vec3 tip0 = Vec3::Zero(), tip1 = Vec3::Zero();
};

class Motion {
 public:
  /// Requires unit axes. Opposite axes leave the great circle open: `is_defined()` is false.
  Motion(const Pose& start, const Pose& end, bool is_dogleg = false);
  explicit Motion(const Pose& alone);

  [[nodiscard]] bool is_defined() const { return is_defined_; }
  [[nodiscard]] bool is_alone() const { return is_alone_; }
  /// Pose at t in [0, 1]; t = 0 and 1 give the end poses bit for bit.
  [[nodiscard]] Pose at(double t) const;
  [[nodiscard]] const std::vector<TipStretch>& stretches() const { return stretches_; }
  /// Rotation of the axis over the whole move, radians.
  [[nodiscard]] double angle_rad() const { return angle_; }
  [[nodiscard]] const Vec3& rotation_axis() const { return rotation_axis_; }
  [[nodiscard]] const Pose& start() const { return start_; }
  [[nodiscard]] const Pose& end() const { return end_; }

 private:
  Pose start_, end_;
  std::vector<TipStretch> stretches_;
  Vec3 rotation_axis_ = Vec3::UnitX();
  double angle_ = 0;
  bool is_defined_ = true;
  bool is_alone_ = false;
};

}  // namespace gouge

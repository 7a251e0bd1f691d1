#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lib/check/check_options.h"
#include "lib/geom/pose.h"
#include "lib/path/toolpath.h"

// The motion of a move: tip linear in t, or on the arc or spline of the move; axis on the great circle with
// constant rate (CL-data meaning); in dogleg mode the tip follows the broken line of axes that all run at one
// speed until each arrives.

namespace gouge {

/// One segment of a motion over [t0, t1] of the move: tip from `tip0` to `tip1`, linear unless the motion
/// is curved.
struct MotionSegment {
  double t0 = 0, t1 = 1;
  Vec3 tip0 = Vec3::Zero(), tip1 = Vec3::Zero();
};

class Motion {
 public:
  /// Requires unit axes. Opposite axes leave the great circle open: `is_defined()` is false.
  Motion(const Pose& start, const Pose& end, bool is_dogleg = false);
  /// Along an arc or helix: one segment, evenly in t.
  Motion(const Pose& start, const Pose& end, const PathArc& arc);
  /// Along a spline whose parameter is t: one segment for each piece. Requires at least one piece.
  Motion(const Pose& start, const Pose& end, const PathSpline& spline);
  explicit Motion(const Pose& alone);

  [[nodiscard]] bool is_defined() const { return is_defined_; }
  [[nodiscard]] bool is_alone() const { return is_alone_; }
  /// Pose at t in [0, 1]; t = 0 and 1 give the end poses bit for bit.
  [[nodiscard]] Pose at(double t) const;
  [[nodiscard]] std::span<const MotionSegment> segments() const {
    return segments_.empty() ? std::span(&whole_, 1) : std::span(segments_);
  }
  /// Tip at t within the segment; exact also on arcs and splines.
  [[nodiscard]] Vec3 tip_at(double t, std::uint32_t segment) const;
  /// The tip's path over [t0, t1] of a segment is no longer than this; straight paths are exactly this long.
  [[nodiscard]] double path_length_mm(double t0, double t1, std::uint32_t segment) const;
  /// How far the tip may at any instant of [t0, t1] be from where it would be on the straight chord at constant
  /// speed. 0 for straight paths. Proof: docs/algorithms/certified_sweep.md, section 3.
  [[nodiscard]] double sag_mm(double t0, double t1, std::uint32_t segment) const;
  /// Rotation of the axis over the whole move, radians.
  [[nodiscard]] double angle_rad() const { return angle_; }
  [[nodiscard]] const Vec3& rotation_axis() const { return rotation_axis_; }
  /// True when no coordinate of the tip, of an arc's centre and radius or of a spline's control points is larger;
  /// false where one is not a number.
  [[nodiscard]] bool is_within(double limit_mm) const;
  [[nodiscard]] const Pose& start() const { return start_; }
  [[nodiscard]] const Pose& end() const { return end_; }

 private:
  /// Tip = center + (r0 + dr t) (cos(sweep t) e1 + sin(sweep t) e2) + (h0 + dh t) axis + t rest.
  struct Turn {
    Vec3 center = Vec3::Zero(), axis = Vec3::UnitZ(), e1 = Vec3::UnitX(), e2 = Vec3::UnitY();
    Vec3 rest = Vec3::Zero();  ///< what the rounding of the numbers leaves at the end
    double sweep = 0, r0 = 0, dr = 0, h0 = 0, dh = 0;
    [[nodiscard]] Vec3 at(double t) const;
    [[nodiscard]] double largest_radius() const { return dr > 0 ? r0 + dr : r0; }
  };

  Pose start_, end_;
  MotionSegment whole_;
  std::vector<MotionSegment> segments_;  // where there is more than one
  CurveKind curve_ = CurveKind::none;
  Turn turn_;                        // of an arc
  std::vector<SplinePiece> pieces_;  // of a spline: one for each segment
  Vec3 rotation_axis_ = Vec3::UnitX();
  double angle_ = 0;
  bool is_defined_ = true;
  bool is_alone_ = false;
};

}  // namespace gouge

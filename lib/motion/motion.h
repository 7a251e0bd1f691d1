#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "lib/geom/pose.h"
#include "lib/motion/axis_law.h"
#include "lib/motion/motion_rates.h"
#include "lib/path/toolpath.h"

namespace gouge {

/// One segment of a motion over [t0, t1] of the move: tip from `tip0` to `tip1`, linear unless the motion
/// is curved.
struct MotionSegment {
  double t0 = 0, t1 = 1;
  Vec3 tip0 = Vec3::Zero(), tip1 = Vec3::Zero();
};

/// The motion of a tool over t in [0, 1]. The tip runs on a line, an arc, a spline, on a broken line of axes that each
/// arrive in their own time, or as an AxisLaw states. The axis turns on the great circle at constant rate, or on the path
/// of an AxisLaw. Only a MotionLaw makes motions, so that no caller chooses a law by accident.
class Motion {
 public:
  /// Returns the other motion that the law admits for this move: both rotary joints evenly (LawScope::documented). None:
  /// it admits this one alone, or any.
  [[nodiscard]] std::optional<Motion> other() const;
  [[nodiscard]] bool has_other() const { return other_path_ != nullptr; }
  /// Returns the same motion as the only one that the law admits.
  [[nodiscard]] Motion alone() const;
  /// Returns true where the law admits every motion of the rotary joints between their ends (LawScope::any). This motion
  /// is one of them.
  [[nodiscard]] bool is_any() const { return is_any_; }
  /// Returns the motion of the tip with the rotary joints at rest at these shares of their ways. Requires is_any() or
  /// has_other().
  [[nodiscard]] Motion at_rest(const TurnShares& shares) const;
  /// Returns the motion that a witness with these shares refers to.
  [[nodiscard]] Motion with(const std::optional<TurnShares>& shares) const;
  /// Returns the shares that a witness at t has: none on the motion that a law states alone or first.
  [[nodiscard]] std::optional<TurnShares> shares_at(double t) const;

  /// Returns false where the law leaves the way of the tool open: opposite axes on the great circle, curves of the path
  /// where the law moves the tip.
  [[nodiscard]] bool is_defined() const { return is_defined_; }
  [[nodiscard]] bool is_alone() const { return is_alone_; }
  /// Returns the pose at t in [0, 1]; t = 0 and 1 give the end poses bit for bit.
  [[nodiscard]] Pose at(double t) const;
  /// Directions of the tool at t in the part: a rotation whose third column is the tool axis, continuous in t. On the
  /// great circle the first column is the direction about which the axis turns. Requires is_defined().
  [[nodiscard]] Eigen::Matrix3d axes_at(double t) const;
  /// Directions of the tool at both ends of a motion on the great circle, as rotary joints state them. None: no joints are
  /// known, or the path of joints states all directions.
  [[nodiscard]] const std::optional<std::array<Eigen::Matrix3d, 2>>& end_directions() const { return end_directions_; }
  /// Returns the rotation that turns the tool from its directions at the start to those at t. Requires is_defined().
  [[nodiscard]] Eigen::Matrix3d turn_to(double t) const;
  [[nodiscard]] std::span<const MotionSegment> segments() const {
    return segments_.empty() ? std::span(&whole_, 1) : std::span(segments_);
  }
  /// Returns false where the tip may leave the straight chord of a segment.
  [[nodiscard]] bool is_straight() const { return curve_ == CurveKind::none && tip_path_ == nullptr; }
  /// Returns the tip at t within the segment; exact also on curves.
  [[nodiscard]] Vec3 tip_at(double t, std::uint32_t segment) const;
  /// Bounds the length of the tip's path over [t0, t1] of a segment; for straight paths it is exact.
  [[nodiscard]] double path_length_mm(double t0, double t1, std::uint32_t segment) const;
  /// Returns how far the tip may at any instant of [t0, t1] be from where it would be on the straight chord at constant
  /// speed. 0 for straight paths. Proof: docs/method/certified_sweep.md, section 3.
  [[nodiscard]] double sag_mm(double t0, double t1, std::uint32_t segment) const;
  /// Returns bounds of all that moves with the tool over [t0, t1] of a segment.
  [[nodiscard]] MotionRates rates(double t0, double t1, std::uint32_t segment) const;
  /// Bounds the turn of the tool over [t0, t1], in radians; on the great circle it is exact.
  [[nodiscard]] double turn_rad(double t0, double t1) const;
  /// Bounds the turn over the whole move.
  [[nodiscard]] double turn_rad() const { return turn_rad(0, 1); }
  /// Returns the path of an AxisLaw; null on the great circle.
  [[nodiscard]] const AxisPath* axis_path() const { return axis_path_.get(); }
  /// Returns false when a coordinate of the tip, of an arc's centre and radius or of a spline's control points is
  /// larger. Also false where one is not a number.
  [[nodiscard]] bool is_within(double limit_mm) const;
  [[nodiscard]] const Pose& start() const { return start_; }
  [[nodiscard]] const Pose& end() const { return end_; }

 private:
  friend class MotionLaw;

  /// Tip on a straight line. Requires unit axes. `law`: null for the great circle; `path`: null for a motion of no path.
  Motion(const Pose& start, const Pose& end, const AxisLaw* law, const Toolpath* path = nullptr, std::size_t move = 0);
  /// The axes of the machine run at one speed until each has arrived.
  void run_dogleg();
  /// Evenly in t along an arc or helix: one segment.
  void run_along(const PathArc& arc);
  /// Along a spline whose parameter is t: one segment for each piece. Requires at least one piece.
  void run_along(const PathSpline& spline);
  void turn_on_great_circle();
  /// By the tip of the AxisPath: one segment between two of its kinks.
  void run_by_law();

  /// Tip = center + (r0 + dr t) (cos(sweep t) e1 + sin(sweep t) e2) + (h0 + dh t) axis + t rest.
  struct Turn {
    Vec3 center = Vec3::Zero(), axis = Vec3::UnitZ(), e1 = Vec3::UnitX(), e2 = Vec3::UnitY();
    Vec3 rest = Vec3::Zero();  ///< remainder at the end from the rounding of the numbers
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
  // On the great circle, about which direction and how far the axis turns.
  Vec3 rotation_axis_ = Vec3::UnitX();
  double angle_ = 0;
  std::shared_ptr<const AxisPath> axis_path_;
  const TipPath* tip_path_ = nullptr;           // of axis_path_
  std::shared_ptr<const AxisPath> other_path_;  // LawScope::documented: of both rotary joints, beside the great circle
  std::optional<std::array<Eigen::Matrix3d, 2>> end_directions_;
  std::optional<TurnShares> rest_;  // the joints rest at these shares
  bool is_even_ = false;            // the motion of both rotary joints, taken from other_path_
  bool is_any_ = false;
  bool is_defined_ = true;
  bool is_alone_ = false;
};

}  // namespace gouge

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lib/certify/motion_checker.h"
#include "lib/tilt/contact_pivot.h"
#include "lib/tilt/tilt_options.h"

namespace gouge {

/// The tilt of a tool axis, rad: x towards TiltPosition::first, y towards TiltPosition::second. Its length is the angle
/// from the programmed axis.
using Tilt = Vec2;

/// A position of a run whose tool axis may be tilted: the end of a move, or an instant of it.
struct TiltPosition {
  std::size_t move = 0;      ///< index in the path
  std::size_t origin = 0;    ///< index of the move before which the remaining stock is that of the position
  double t = 1;              ///< instant of that move; 1: its end
  double arc_length_mm = 0;  ///< length of the tip's path from the beginning of the run, plus 10 mm for each radian
                             ///< that the axis turns
  MoveKind kind = MoveKind::feed;
  Pose programmed;
  Vec3 first = Vec3::UnitX(), second = Vec3::UnitY();  ///< unit, square to the axis and to each other
  ContactPivot pivot{Pose{}};
  double tolerance_share = 0;  ///< share of the tolerance to which the cutter may be in the part here
  /// The only allowed tilt, if there is one. It is zero if the position stays as programmed, or the tilt of another
  /// pass through the same place.
  std::optional<Tilt> given;
  bool is_reached_clean = false;  ///< the programmed motion from the position before is clean

  [[nodiscard]] Vec3 axis_for(const Tilt& tilt) const;
  /// Returns the tilt that leads to `axis`. Requires an angle of less than half a circle from the programmed axis.
  [[nodiscard]] Tilt tilt_to(const Vec3& axis) const;
  [[nodiscard]] bool is_fixed() const { return given.has_value(); }
  [[nodiscard]] bool stays_programmed() const { return given && given->isZero(0); }
};

/// Distance of the tilts of positions from the limits, for the motions between them.
inline constexpr double kLimitMargin_rad = 2e-4;

/// The constraints that every tilt of a run must meet.
struct TiltTask {
  const ToolVariants* tool = nullptr;
  const MotionChecker* checker = nullptr;
  TiltOptions options;
  /// Allows the tip to rise off the part where the tilted cutter would gouge.
  bool may_raise = false;
};

/// Points of the part and of fixtures that were in the tool at refused tilts. Most are in the tool at other tilts too,
/// which is a fast test. The points do not change the result.
using RefusingPoints = std::vector<Witness>;

/// Returns directions of tilt all around, or the two that the freedom allows. Unit vectors.
[[nodiscard]] std::vector<Tilt> tilt_directions(TiltFreedom freedom);

/// The free tilts at the positions of a run and the free motions between them. Any thread may call it; the results are
/// always the same.
class TiltSpace {
 public:
  /// The objects that `task` refers to must outlive it.
  TiltSpace(std::vector<TiltPosition> positions, const TiltTask& task);

  [[nodiscard]] std::size_t size() const { return positions_.size(); }
  [[nodiscard]] const TiltPosition& operator[](std::size_t i) const { return positions_[i]; }
  [[nodiscard]] const TiltTask& task() const { return task_; }

  /// Returns the pose of the tool at a tilt. It keeps the contact and rises if that is necessary and allowed. Without
  /// tilt it is the programmed pose, bit for bit. Returns nothing if rising does not help.
  [[nodiscard]] std::optional<Pose> pose(std::size_t i, const Tilt& tilt) const;

  /// Returns the rise of the tip at a tilt; nothing if rising does not help. The point that shows it is then added to
  /// `refusing`, if given.
  [[nodiscard]] std::optional<double> raise_mm(std::size_t i, const Tilt& tilt,
                                               RefusingPoints* refusing = nullptr) const;

  /// Returns whether one of the points proves that the tilt is not free at any rise of the tip.
  [[nodiscard]] bool is_refused_by(RefusingPoints& refusing, std::size_t i, const Tilt& tilt) const;

  /// Returns whether the tool is certified free at the tilt and within the limits. It keeps a margin for the motions
  /// before and after. If `refusing` is given, its points are tested first and new ones are added.
  [[nodiscard]] bool is_free(std::size_t i, const Tilt& tilt, RefusingPoints* refusing = nullptr) const;

  /// Returns whether the motion from position i with tilt `from` to position k > i with tilt `to` is certified clean.
  /// The motion must also be within the limits of the axis at every instant. Requires that both positions are free or
  /// programmed.
  [[nodiscard]] bool is_free_between(std::size_t i, const Tilt& from, std::size_t k, const Tilt& to) const;

  /// Returns whether the limits of turns allow the turn of the axis between the two positions. This test is not part of
  /// is_free_between, because the speed of a tilt's changes depends on the whole run.
  [[nodiscard]] bool may_turn(std::size_t i, const Tilt& from, std::size_t k, const Tilt& to) const;

  /// Returns the maximum change of tilt from position i to i + 1. A larger change turns the tool too much between the
  /// two (docs/method/tilting.md, "The cut between positions").
  [[nodiscard]] double largest_change_rad(std::size_t i) const;

  /// Returns whether position i stays as programmed and makes every sequence of tilts impossible. It does if the tool
  /// is too deep there for any motion. Then its neighbours would have to stay as programmed too, and one of them
  /// cannot.
  [[nodiscard]] bool holds_back(std::size_t i) const;

  /// Returns the largest tilt that keeps the margin to --max-tilt.
  [[nodiscard]] double largest_tilt_rad() const;

  /// Returns whether a tilt is within --max-tilt and the cone, and the machine can reach it without a rise of the tip.
  [[nodiscard]] bool is_permitted(std::size_t i, const Tilt& tilt) const;

  /// Returns the largest permitted angle in a direction, a unit vector.
  [[nodiscard]] double largest_permitted_rad(std::size_t i, const Tilt& direction) const;

  /// Names the joint that keeps the machine from a tilt, with its limit; empty: none does.
  [[nodiscard]] std::string why_not_reached(std::size_t i, const Tilt& tilt) const;

  /// Returns the obstacle to the tool at a tilt, and the depth of the gouge.
  [[nodiscard]] MoveVerdict verdict(std::size_t i, const Tilt& tilt) const;

 private:
  [[nodiscard]] bool can_reach(std::size_t i, const Pose& pose) const;
  [[nodiscard]] bool stays_within_limits(std::size_t i, const Pose& from, std::size_t k, const Pose& to) const;
  [[nodiscard]] double largest_turn_rad(std::size_t i, std::size_t k) const;
  [[nodiscard]] CheckOptions options_for(double tolerance_share) const;
  [[nodiscard]] MotionChecker checker_at(std::size_t i) const;
  [[nodiscard]] bool is_gouge(std::size_t i, MoveKind kind) const;
  [[nodiscard]] bool may_stay_programmed(std::size_t i) const;
  /// Returns the pose that keeps the contact, without a rise.
  [[nodiscard]] Pose kept_pose(std::size_t i, const Tilt& tilt) const;
  [[nodiscard]] Pose raised_pose(std::size_t i, const Tilt& tilt, double raised_mm) const;
  [[nodiscard]] double max_raise_mm() const;
  /// Returns whether one of the points is deeper in the tool than allowed, by more than `deeper_mm`.
  [[nodiscard]] bool is_refused(const Pose& pose, double deeper_mm, const CheckOptions& options,
                                RefusingPoints& refusing) const;

  /// Returns whether one of the points is deeper in the cutter than allowed at any rise of the tip.
  [[nodiscard]] bool stays_too_deep(std::size_t i, const Pose& kept, const RefusingPoints& refusing) const;

  std::vector<TiltPosition> positions_;
  TiltTask task_;
  bool is_cutter_convex_ = false;
};

/// The tilt last found free at each position of a run, and on the motion to the next position. So only the changed
/// parts of a sequence need a new proof. Different threads may query different positions.
class TiltProofs {
 public:
  explicit TiltProofs(const TiltSpace& space) : space_(space), free_at_(space.size()), free_after_(space.size()) {}

  [[nodiscard]] bool is_free(std::size_t i, const Tilt& tilt);
  /// Returns whether the motion from position i to the next position is free.
  [[nodiscard]] bool is_free_after(std::size_t i, const Tilt& from, const Tilt& to);

 private:
  const TiltSpace& space_;
  std::vector<std::optional<Tilt>> free_at_;
  std::vector<std::optional<std::pair<Tilt, Tilt>>> free_after_;
};

}  // namespace gouge

#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "lib/certify/motion_checker.h"
#include "lib/tilt/contact_pivot.h"
#include "lib/tilt/tilt_options.h"

namespace gouge {

/// By how much a tool axis is tilted, rad: about the square of TiltPosition::second towards the first, as x, and
/// towards the second, as y. Its length is the angle from the programmed axis.
using Tilt = Vec2;

/// A position of a run whose tool axis may be tilted: the end of a move, or an instant of it.
struct TiltPosition {
  std::size_t move = 0;      ///< of the path
  double t = 1;              ///< instant of that move; 1: its end
  double arc_length_mm = 0;  ///< of the tip from the run's beginning, and 10 mm for each radian that the axis turns
  MoveKind kind = MoveKind::feed;
  Pose programmed;
  Vec3 first = Vec3::UnitX(), second = Vec3::UnitY();  ///< unit, square to the axis and to each other
  ContactPivot pivot{Pose{}};
  double tolerance_share = 0;  ///< of the tolerance: how deep the cutter may be in the part here
  /// Where it has no choice: none where it stays as programmed, or that of another pass through the same place.
  std::optional<Tilt> given;
  bool is_reached_clean = false;  ///< the programmed motion from the position before is clean

  [[nodiscard]] Vec3 axis_for(const Tilt& tilt) const;
  /// Returns the tilt with that axis, which is less than half a circle from the programmed one.
  [[nodiscard]] Tilt tilt_to(const Vec3& axis) const;
  [[nodiscard]] bool is_fixed() const { return given.has_value(); }
  [[nodiscard]] bool stays_programmed() const { return given && given->isZero(0); }
};

/// The constraints that every tilt of a run must meet.
struct TiltTask {
  const ToolVariants* tool = nullptr;
  const MotionChecker* checker = nullptr;
  TiltOptions options;
  /// The tip rises off the part where the tilted cutter would gouge it.
  bool may_raise = false;
};

/// Points of the part and the fixtures that were in the tool at tilts that were refused. Most are in it at others too,
/// which is seen at once. The result is the same without.
using RefusingPoints = std::vector<Witness>;

/// Free tilts at the positions of a run, and free turns between them. The results do not depend on the caller, from
/// any thread.
class TiltSpace {
 public:
  /// The objects that `task` refers to must outlive it.
  TiltSpace(std::vector<TiltPosition> positions, const TiltTask& task);

  [[nodiscard]] std::size_t size() const { return positions_.size(); }
  [[nodiscard]] const TiltPosition& operator[](std::size_t i) const { return positions_[i]; }
  [[nodiscard]] const TiltTask& task() const { return task_; }

  /// Returns where the tool stands: the contact kept, and raised where it must be and may. Without tilt as programmed,
  /// bit for bit. Nothing where raising does not help.
  [[nodiscard]] std::optional<Pose> pose(std::size_t i, const Tilt& tilt) const;

  /// Returns how far it is raised there; nothing where raising does not help, of which `refusing`, where given, learns.
  [[nodiscard]] std::optional<double> raise_mm(std::size_t i, const Tilt& tilt,
                                               RefusingPoints* refusing = nullptr) const;

  /// Returns whether one of the points shows that the tilt is not free, however the tip is raised.
  [[nodiscard]] bool is_refused_by(RefusingPoints& refusing, std::size_t i, const Tilt& tilt) const;

  /// Returns whether the tool is certified free there, with a margin for the motions beside it, and within the limits.
  /// Where `refusing` is given, it is tested first and learns.
  [[nodiscard]] bool is_free(std::size_t i, const Tilt& tilt, RefusingPoints* refusing = nullptr) const;

  /// Returns whether the motion from position i with one tilt to position k > i with another is certified clean. It
  /// must also be within the limits of the axis at every instant. Requires that both are free or programmed.
  [[nodiscard]] bool is_free_between(std::size_t i, const Tilt& from, std::size_t k, const Tilt& to) const;

  /// Returns whether the axis may turn so far on that way. That is not part of being free: how fast a tilt comes and
  /// goes is a matter of the whole run.
  [[nodiscard]] bool may_turn(std::size_t i, const Tilt& from, std::size_t k, const Tilt& to) const;

  /// Returns the largest change of tilt from position i to i + 1. A larger one turns the tool too far between the two.
  /// docs/method/tilting.md, "The cut between positions"
  [[nodiscard]] double largest_change_rad(std::size_t i) const;

  /// Returns whether position i, which stays as programmed, lets no sequence of tilts be free. The tool is too deep
  /// there for any motion. So its neighbours would have to stay as programmed too, and one of them cannot.
  [[nodiscard]] bool holds_back(std::size_t i) const;

  /// Returns the obstacle to the tool at a tilt, and its depth.
  [[nodiscard]] MoveVerdict verdict(std::size_t i, const Tilt& tilt) const;

 private:
  [[nodiscard]] bool stays_within_limits(std::size_t i, const Pose& from, std::size_t k, const Pose& to) const;
  [[nodiscard]] double largest_turn_rad(std::size_t i, std::size_t k) const;
  [[nodiscard]] CheckOptions options_for(double tolerance_share) const;
  [[nodiscard]] bool is_gouge(std::size_t i, MoveKind kind) const;
  [[nodiscard]] bool may_stay_programmed(std::size_t i) const;
  /// Returns the contact kept, and not raised.
  [[nodiscard]] Pose kept_pose(std::size_t i, const Tilt& tilt) const;
  [[nodiscard]] Pose raised_pose(std::size_t i, const Tilt& tilt, double raised_mm) const;
  [[nodiscard]] double max_raise_mm() const;
  /// Returns whether a point is deeper in the tool than it may be, and by `deeper_mm` more.
  [[nodiscard]] bool is_refused(const Pose& pose, double deeper_mm, const CheckOptions& options,
                                RefusingPoints& refusing) const;

  /// Returns whether a point is deeper in the cutter than it may be, however the tip is raised.
  [[nodiscard]] bool stays_too_deep(std::size_t i, const Pose& kept, const RefusingPoints& refusing) const;

  std::vector<TiltPosition> positions_;
  TiltTask task_;
  bool is_cutter_convex_ = false;
};

/// The tilt last found free at each position of a run, and on the motion from it to the next. So a sequence that
/// changes in places is proved in these places alone. Different positions may be queried from different threads.
class TiltProofs {
 public:
  explicit TiltProofs(const TiltSpace& space) : space_(space), free_at_(space.size()), free_after_(space.size()) {}

  [[nodiscard]] bool is_free(std::size_t i, const Tilt& tilt);
  /// Returns whether the motion from position i to the next is free.
  [[nodiscard]] bool is_free_after(std::size_t i, const Tilt& from, const Tilt& to);

 private:
  const TiltSpace& space_;
  std::vector<std::optional<Tilt>> free_at_;
  std::vector<std::optional<std::pair<Tilt, Tilt>>> free_after_;
};

}  // namespace gouge

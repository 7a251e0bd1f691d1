#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "lib/base/tolerance.h"
#include "postproc/cldata/interpreting/emit.h"

namespace gouge {
namespace {

Position step_to(const Position& position, const Vec3& tip_local) {
  Position step = position;
  step.tip_local = tip_local;
  step.form = PositionForm::cycle;
  return step;
}

// Emits a retraction through `tip_local` to an unknown plane. The tool moves from there to the next position.
void emit_retract(States& s, const Position& position, const Vec3& tip_local) {
  const Position step = step_to(position, tip_local);
  Move move = make_move(s, step, MoveKind::cycle);
  move.set_feed({0, FeedUnit::rapid});
  if (move.not_checked_reason.empty()) move.not_checked_reason = Reasons::kRetractPlane;
  append(s, move, step);
  s.chain.lose_start(Reasons::kAfterCycle);
}

void emit_step(States& s, const Position& position, const Vec3& tip_local, bool is_rapid) {
  const Position step = step_to(position, tip_local);
  Move move = make_move(s, step, MoveKind::cycle);
  const std::optional<Pose>& last = s.chain.last_pose();
  const bool is_same_point = move.has_start && (last->tip - move.end.tip).norm() <= Tolerance::kSamePoint_mm &&
                             last->axis.cross(move.end.axis).norm() <= Tolerance::kSameDirection;
  if (is_same_point) return;
  if (is_rapid) move.set_feed({0, FeedUnit::rapid});
  if (s.cycle.drill()->is_tapping && move.is_spindle_stopped()) move.spindle_rpm = 0;  // tapping turns it
  const Feed& plunge = s.cycle.drill()->feed;
  if (!is_rapid && plunge.unit != FeedUnit::not_stated) move.set_feed(plunge);
  append(s, move, step);
}

// Returns the retract height above the position; nothing if neither the cycle nor the user states it. A plane is used
// only for an upright tool, and if it is not below the clearance.
std::optional<double> retract_of(States& s, const Position& position, const DrillCycle& cycle) {
  if (cycle.is_retract_known) return cycle.retract_mm;
  const std::optional<double>& plane_mm = s.in.path.retract_plane_mm;
  const Vec3& axis = position.axis_local;
  const bool is_upright = axis.z() > 0 && axis.cross(Vec3::UnitZ()).norm() <= Tolerance::kSameDirection;
  if (!plane_mm || !is_upright || !cycle.is_retract_left_open) return std::nullopt;
  const double height_mm = *plane_mm - position.tip_local.z();
  if (height_mm >= cycle.retract_mm) return height_mm;
  s.cycle.note_low_plane();
  return std::nullopt;
}

// Emits the rise to a higher hole in three readings: first up and then across, straight, or first across.
void emit_rise(States& s, const Position& position, double height, double clearance_mm) {
  const Pose start = *s.chain.last_pose();
  const Vec3 axis = position.axis_local;
  const auto at = [&](double mm) {
    return s.frame.to_part().pose({Vec3(position.tip_local + mm * axis), position.axis_local});
  };
  Position open = position;
  open.uncertainty = Reasons::kHigherHole;
  open.cover = Cover::motion;
  emit_step(s, open, s.frame.to_local(start).tip + (clearance_mm - height) * axis, true);
  emit_step(s, open, position.tip_local + clearance_mm * axis, true);
  const Pose above = at(clearance_mm);
  const std::array<Pose, 2> across = {at(height), above};
  emit_other_way(s, step_to(open, position.tip_local), start, {&above, 1}, Reasons::kHigherHole);
  emit_other_way(s, step_to(open, position.tip_local), start, across, Reasons::kHigherHole);
}

// Returns the heights above the position at which the tool may be between holes.
std::vector<double> levels_of(const DrillCycle& cycle, double position_z_mm) {
  std::vector<double> levels = cycle.levels_mm;
  for (const double plane_mm : cycle.planes_mm) {
    if (plane_mm > position_z_mm) levels.push_back(plane_mm - position_z_mm);
  }
  return levels;
}

// Emits the ways from the present place: the tool goes across, or straight to any of the levels. Returns false if it is
// too low for this.
bool emit_bounds_from(States& s, const Position& position, const std::vector<Pose>& places, double top_mm) {
  const Pose start = *s.chain.last_pose();
  const Vec3 here = s.frame.to_local(start).tip;
  const double height = (here - position.tip_local).dot(position.axis_local);
  const Vec3 across = position.tip_local + height * position.axis_local;
  if ((across - here).norm() <= Tolerance::kSamePoint_mm) return true;
  if (height < top_mm) return false;
  emit_step(s, position, across, true);
  const Pose end = s.in.path.moves.back().end;
  for (const Pose& place : places) {
    const std::array<Pose, 2> ends = {place, end};
    emit_other_way(s, position, start, ends, position.uncertainty);
  }
  return true;
}

// Emits the ways from one hole to the next at any of the levels. Returns false if the levels of both holes have
// different heights.
bool emit_bounds_between(States& s, const Position& position, const std::vector<Pose>& from,
                         const std::vector<Pose>& places, double top_mm) {
  const Vec3 up = s.frame.to_part().direction(position.axis_local);
  if (from.size() != places.size()) return false;
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (std::abs((from[i].tip - places[i].tip).dot(up)) > Tolerance::kSamePoint_mm) return false;
  }
  emit_step(s, position, position.tip_local + top_mm * position.axis_local, true);
  const Pose end = s.in.path.moves.back().end;
  for (std::size_t i = 0; i < from.size(); ++i) {
    const std::array<Pose, 2> ends = {places[i], end};
    emit_other_way(s, position, from[i], ends, position.uncertainty);
  }
  return true;
}

// Emits a column that contains the hole, independent of which end of the hole the position is, and all ways to the
// column.
void emit_bounds(States& s, const Position& own, const DrillCycle& cycle) {
  Position position = step_to(own, own.tip_local);
  position.uncertainty = Reasons::kHoleBounds;
  position.cover = Cover::motion;
  const std::vector<double> levels = levels_of(cycle, own.tip_local.z());
  const double top_mm = *std::ranges::max_element(levels);
  std::vector<Pose> places;
  for (const double mm : levels)
    places.push_back(s.frame.to_part().pose({Vec3(own.tip_local + mm * own.axis_local), own.axis_local}));
  const std::vector<Pose> from = std::exchange(s.open_places, {});
  const bool is_upright =
      own.axis_local.cross(Vec3::UnitZ()).norm() <= Tolerance::kSameDirection && own.axis_local.z() > 0;
  bool is_read = is_upright && own.uncertainty == nullptr;
  if (is_read && s.chain.last_pose()) {
    const bool is_start_read =
        s.chain.is_start_certain() &&
        s.frame.to_local(*s.chain.last_pose()).axis.cross(own.axis_local).norm() <= Tolerance::kSameDirection;
    is_read = is_start_read && (from.empty() ? emit_bounds_from(s, position, places, top_mm)
                                             : emit_bounds_between(s, position, from, places, top_mm));
  }
  if (!is_read) position.cover = Cover::none;
  const auto at = [&](double mm) { return Vec3(own.tip_local + mm * own.axis_local); };
  emit_step(s, position, at(top_mm), true);
  emit_step(s, position, at(cycle.bottom_mm), false);
  emit_step(s, position, at(top_mm), true);
  s.cycle.note_hole(s.frame.to_part().pose({own.tip_local, own.axis_local}));
  if (is_read) {
    s.open_places = std::move(places);
  } else {
    s.chain.lose_start(Reasons::kAfterCycle);
  }
}

}  // namespace

// Emits a hole. The tool goes to a height above the position before it goes down. It keeps its height, or first rises
// to the clearance if that is higher. A tool that must turn goes there straight, and turns on the way.
void emit_hole(States& s, const Position& own, const DrillCycle& cycle) {
  Position position = own;
  if (std::exchange(s.is_behind_skip, false) && position.uncertainty == nullptr) position.uncertainty = s.skip_reason;
  if (std::exchange(s.retracted, std::nullopt) && position.uncertainty == nullptr)
    position.uncertainty = Reasons::kAfterRetract;
  if (cycle.is_bounding) return emit_bounds(s, position, cycle);
  if (!std::exchange(s.open_places, {}).empty() && position.uncertainty == nullptr)
    position.uncertainty = Reasons::kHoleBounds;
  const Vec3& axis = position.axis_local;
  const std::size_t before = s.in.moves();
  const auto above = [&](double height_mm) { return Vec3(position.tip_local + height_mm * axis); };
  if (s.chain.is_start_certain()) {
    const Pose here = s.frame.to_local(*s.chain.last_pose());
    const double height = (here.tip - position.tip_local).dot(axis);
    if (here.axis.cross(axis).norm() > Tolerance::kSameDirection) {
      emit_step(s, position, above(cycle.retract_mm), true);
    } else if (height < cycle.clearance_mm && (here.tip - above(height)).norm() > Tolerance::kSamePoint_mm) {
      emit_rise(s, position, height, cycle.clearance_mm);
    } else if (height < cycle.clearance_mm) {
      emit_step(s, position, here.tip + (cycle.clearance_mm - height) * axis, true);
    } else {
      emit_step(s, position, above(height), true);
    }
  }
  emit_step(s, position, above(cycle.clearance_mm), true);
  emit_step(s, position, above(cycle.bottom_mm), false);
  if (const std::optional<double> retract_mm = retract_of(s, position, cycle)) {
    // Controls feed out to the clearance alone, and go on from there in rapid.
    if (cycle.is_fed_out) emit_step(s, position, above(cycle.clearance_mm), false);
    emit_step(s, position, above(*retract_mm), true);
  } else {
    emit_retract(s, position, above(cycle.retract_mm));
  }
  // A cycle without motion is a move too.
  if (s.in.moves() == before) append(s, make_move(s, position, MoveKind::cycle), position);
  s.cycle.note_hole(s.frame.to_part().pose({position.tip_local, position.axis_local}));
}

}  // namespace gouge

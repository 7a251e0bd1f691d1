#include "lib/tilt/tilt_space.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "lib/base/best_first_search.h"
#include "lib/base/tolerance.h"
#include "lib/contact/contacts.h"
#include "lib/contact/cutter_sweep.h"
#include "lib/path/path_info.h"
#include "lib/tool/evaluate.h"

namespace gouge {
namespace {

constexpr double kBend = 0.5;  // maximum error of the surface between two positions, as a share of the tolerance
constexpr std::size_t kMaxRefusing = 24;
constexpr int kMaxRaises = 12;
constexpr double kSure_rad = 1e-7;
constexpr int kMaxHalvings = 24;
constexpr double kMaxShare = 0.97;  // share of the tolerance for a motion that is deeper than its share kMotionAimShare

void learn(const Witness& witness, RefusingPoints& refusing) {
  refusing.insert(refusing.begin(), witness);
  if (refusing.size() > kMaxRefusing) refusing.pop_back();
}

}  // namespace

Vec3 TiltPosition::axis_for(const Tilt& tilt) const {
  const double angle = tilt.norm();
  if (!(angle > 0)) return programmed.axis;
  const Vec3 towards = (tilt.x() * first + tilt.y() * second) / angle;
  return (std::cos(angle) * programmed.axis + std::sin(angle) * towards).normalized();
}

Tilt TiltPosition::tilt_to(const Vec3& axis) const {
  const Tilt towards(axis.dot(first), axis.dot(second));
  const double across = towards.norm();
  return across > 0 ? Tilt(std::atan2(across, axis.dot(programmed.axis)) / across * towards) : Tilt(Tilt::Zero());
}

std::vector<Tilt> tilt_directions(TiltFreedom freedom) {
  constexpr int kAround = 12;
  std::vector<Tilt> directions;
  for (int k = 0; k < kAround; ++k) {
    if (freedom == TiltFreedom::lead && k % (kAround / 2) != 0) continue;
    if (freedom == TiltFreedom::side && k % (kAround / 2) != kAround / 4) continue;
    const double angle = k * 2 * std::numbers::pi / kAround;
    directions.emplace_back(std::cos(angle), std::sin(angle));
  }
  return directions;
}

TiltSpace::TiltSpace(std::vector<TiltPosition> positions, const TiltTask& task)
    : positions_(std::move(positions)),
      task_(task),
      is_cutter_convex_(task.tool != nullptr && is_convex(task.tool->cutting)) {}

CheckOptions TiltSpace::options_for(double tolerance_share) const {
  CheckOptions options = task_.checker->options();
  options.tolerance_mm *= tolerance_share;
  options.near_miss_mm = 0;
  return options;
}

Pose TiltSpace::kept_pose(std::size_t i, const Tilt& tilt) const {
  const TiltPosition& at = positions_[i];
  if (!(tilt.norm() > 0)) return at.programmed;
  const Vec3 axis = at.axis_for(tilt);
  return {at.pivot.tip_for(axis), axis};
}

double TiltSpace::max_raise_mm() const { return task_.may_raise ? task_.options.max_raise_mm : 0; }

std::optional<Pose> TiltSpace::pose(std::size_t i, const Tilt& tilt) const {
  const std::optional<double> raised_mm = raise_mm(i, tilt);
  return raised_mm ? std::optional(raised_pose(i, tilt, *raised_mm)) : std::nullopt;
}

Pose TiltSpace::raised_pose(std::size_t i, const Tilt& tilt, double raised_mm) const {
  Pose pose = kept_pose(i, tilt);
  if (raised_mm > 0) pose.tip += raised_mm * positions_[i].pivot.normal();
  return pose;
}

std::optional<double> TiltSpace::raise_mm(std::size_t i, const Tilt& tilt, RefusingPoints* refusing) const {
  if (!task_.may_raise || !(tilt.norm() > 0)) return 0;
  const Pose kept = kept_pose(i, tilt);
  Pose pose = kept;
  const TiltPosition& at = positions_[i];
  const double aim = at.tolerance_share * task_.checker->options().tolerance_mm;
  double raised_mm = 0;
  for (int k = 0; k < kMaxRaises; ++k) {
    const double excess =
        largest_excess(pose, task_.tool->cutting, task_.checker->scene(), aim, Tolerance::kCorrection_mm);
    if (excess <= 0) return raised_mm;
    raised_mm += excess + Tolerance::kCorrection_mm;
    if (raised_mm > task_.options.max_raise_mm) break;
    pose.tip = kept.tip + raised_mm * at.pivot.normal();
  }
  if (refusing == nullptr) return std::nullopt;
  const auto deepest = find_deepest_contact(pose, task_.tool->cutting, task_.checker->scene().workpiece_tree(), aim);
  if (deepest) {
    Witness witness;
    witness.point = deepest->point;
    learn(witness, *refusing);
  }
  return std::nullopt;
}

bool TiltSpace::is_refused(const Pose& pose, double deeper_mm, const CheckOptions& options,
                           RefusingPoints& refusing) const {
  const double allowed = options.tolerance_mm + options.resolution_mm + Tolerance::kWitness_mm + deeper_mm;
  const auto found = std::ranges::find_if(refusing, [&](const Witness& in) {
    return signed_distance_mm(task_.tool->*rule_of(in.against).form, pose, in.point) < -allowed;
  });
  if (found == refusing.end()) return false;
  std::rotate(refusing.begin(), found, found + 1);
  return true;
}

// If the tool rises by a distance, no point leaves it by more than that distance.
bool TiltSpace::is_refused_by(RefusingPoints& refusing, std::size_t i, const Tilt& tilt) const {
  const CheckOptions options = options_for(positions_[i].tolerance_share);
  const Pose kept = kept_pose(i, tilt);
  if (is_refused(kept, max_raise_mm(), options, refusing)) return true;
  return task_.may_raise && tilt.norm() > 0 && stays_too_deep(i, kept, refusing);
}

// While a convex cutter rises, the signed distance of a point is a convex function. Its maximum is at one of both ends.
bool TiltSpace::stays_too_deep(std::size_t i, const Pose& kept, const RefusingPoints& refusing) const {
  if (!is_cutter_convex_) return false;
  const TiltPosition& at = positions_[i];
  const double allowed =
      at.tolerance_share * task_.checker->options().tolerance_mm + Tolerance::kCorrection_mm + Tolerance::kWitness_mm;
  const Pose raised{kept.tip + max_raise_mm() * at.pivot.normal(), kept.axis};
  const CompiledTool& cutter = task_.tool->cutting;
  return std::ranges::any_of(refusing, [&](const Witness& in) {
    return rule_of(in.against).is_workpiece && signed_distance_mm(cutter, kept, in.point) < -allowed &&
           signed_distance_mm(cutter, raised, in.point) < -allowed;
  });
}

double TiltSpace::largest_tilt_rad() const {
  constexpr double kShare = 0.999, kMinShare = 0.5, kMarginAndRounding = 1.01;
  const double limit_rad = task_.options.max_tilt_rad;
  return std::min(kShare * limit_rad,
                  std::max(limit_rad - kMarginAndRounding * kLimitMargin_rad, kMinShare * limit_rad));
}

bool TiltSpace::can_reach(std::size_t i, const Pose& pose) const {
  const PoseReach* const reach = task_.options.reach.get();
  return reach == nullptr || reach->can_reach(positions_[i].origin, positions_[i].programmed.axis, pose);
}

bool TiltSpace::is_permitted(std::size_t i, const Tilt& tilt) const {
  if (!(tilt.norm() > 0)) return true;
  if (tilt.norm() > task_.options.max_tilt_rad + kSure_rad) return false;
  const auto& cone = task_.options.cone;
  const Pose pose = kept_pose(i, tilt);
  if (cone && angle_between_rad(pose.axis, cone->axis) > cone->half_angle_rad + kSure_rad) return false;
  return can_reach(i, pose);
}

double TiltSpace::largest_permitted_rad(std::size_t i, const Tilt& direction) const {
  constexpr int kSteps = 6, kHalvings = 20;
  const double step = task_.options.max_tilt_rad / kSteps;
  int within_steps = kSteps;
  while (within_steps > 0 && !is_permitted(i, within_steps * step * direction)) --within_steps;
  double within = within_steps * step, beyond = within + step;
  for (int k = 0; k < kHalvings && within_steps < kSteps; ++k) {
    const double middle = 0.5 * (within + beyond);
    (is_permitted(i, middle * direction) ? within : beyond) = middle;
  }
  return within;
}

std::string TiltSpace::why_not_reached(std::size_t i, const Tilt& tilt) const {
  const PoseReach* const reach = task_.options.reach.get();
  if (reach == nullptr || !(tilt.norm() > 0)) return {};
  return reach->why_not(positions_[i].origin, positions_[i].programmed.axis, kept_pose(i, tilt));
}

bool TiltSpace::is_free(std::size_t i, const Tilt& tilt, RefusingPoints* refusing) const {
  const TiltPosition& at = positions_[i];
  if (tilt.norm() > task_.options.max_tilt_rad - kLimitMargin_rad) return false;
  const auto& cone = task_.options.cone;
  if (cone && angle_between_rad(at.axis_for(tilt), cone->axis) > cone->half_angle_rad - kLimitMargin_rad) return false;
  // Without a tilt the position stays as programmed, even at a limit.
  const bool is_tilted = tilt.norm() > 0;
  if (is_tilted && !can_reach(i, kept_pose(i, tilt))) return false;
  CheckOptions options = options_for(at.tolerance_share);
  if (refusing != nullptr && is_refused_by(*refusing, i, tilt)) return false;
  const std::optional<double> raised_mm = raise_mm(i, tilt, refusing);
  if (!raised_mm) return false;
  const Pose pose = raised_pose(i, tilt, *raised_mm);
  if (*raised_mm > 0 && !can_reach(i, pose)) return false;
  if (refusing != nullptr && task_.may_raise && is_refused(pose, 0, options, *refusing)) return false;
  options.near_miss_mm = kAir_mm;
  options.gouge_gap_mm = kAnyGap_mm;
  // An end of the run is outside of solids. From there clean motions lead to every position of a proved sequence.
  const MoveVerdict verdict = checker_at(i).check(options.law.at(pose), at.kind, *task_.tool, options, true);
  // A point of the stock may be gone at other positions.
  const bool is_of_tool = verdict.witness && verdict.witness->body != Body::head && !verdict.is_in_stock();
  if (refusing != nullptr && verdict.state == MoveState::gouge && is_of_tool) {
    learn(*verdict.witness, *refusing);
  }
  return verdict.state == MoveState::clean;
}

bool TiltSpace::may_turn(std::size_t i, const Tilt& from, std::size_t k, const Tilt& to) const {
  const TiltOptions& limits = task_.options;
  if (!limits.has_turn_limit()) return true;
  const double turn = angle_between_rad(positions_[i].axis_for(from), positions_[k].axis_for(to));
  const double programmed = angle_between_rad(positions_[i].programmed.axis, positions_[k].programmed.axis);
  const auto start = pose(i, from), end = pose(k, to);
  const double arc_length_mm = start && end ? (end->tip - start->tip).norm() : 0;
  const double allowed =
      std::min(limits.max_turn_step_rad, limits.max_turn_rad_per_mm * std::max(arc_length_mm, Tolerance::kWitness_mm));
  return turn <= std::max(allowed, programmed);
}

bool TiltSpace::stays_within_limits(std::size_t i, const Pose& from, std::size_t k, const Pose& to) const {
  const MotionLaw& law = task_.checker->options().law;
  const Motion programmed = law.straight(positions_[i].programmed, positions_[k].programmed),
               tilted = law.straight(from, to);
  const TiltOptions& limits = task_.options;
  // Between two instants, an angle between axes is at most half the sum of its end values and of the turns of both
  // axes.
  const auto stays = [&](const auto& self, double t0, double t1, int level) -> bool {
    const double turn = (t1 - t0) * (programmed.turn_rad() + tilted.turn_rad());
    const Vec3 a0 = tilted.at(t0).axis, a1 = tilted.at(t1).axis;
    const auto is_within = [&](double angle0, double angle1, double limit) {
      return 0.5 * (angle0 + angle1 + turn) <= limit + kSure_rad;
    };
    const double tilt0 = angle_between_rad(a0, programmed.at(t0).axis),
                 tilt1 = angle_between_rad(a1, programmed.at(t1).axis);
    bool is_sure = is_within(tilt0, tilt1, limits.max_tilt_rad);
    double most = std::max(tilt0, tilt1) - limits.max_tilt_rad;
    if (limits.cone) {
      const double off0 = angle_between_rad(a0, limits.cone->axis), off1 = angle_between_rad(a1, limits.cone->axis);
      is_sure = is_sure && is_within(off0, off1, limits.cone->half_angle_rad);
      most = std::max({most, off0 - limits.cone->half_angle_rad, off1 - limits.cone->half_angle_rad});
    }
    if (is_sure) return true;
    if (most > kSure_rad || level == kMaxHalvings) return false;
    const double middle = 0.5 * (t0 + t1);
    return self(self, t0, middle, level + 1) && self(self, middle, t1, level + 1);
  };
  return stays(stays, 0, 1, 0);
}

/// A turn by an angle on a straight path of the tip bends the paths of the tool's other points. A point leaves its
/// straight path by distance * angle^2 / 8, where the distance is that from the tip. The cut surface may be wrong by as
/// much in between.
double TiltSpace::largest_turn_rad(std::size_t i, std::size_t k) const {
  const double programmed = angle_between_rad(positions_[i].programmed.axis, positions_[k].programmed.axis);
  const double allowed_mm = kBend * task_.checker->options().tolerance_mm;
  const double angle = std::sqrt(8 * allowed_mm / std::max(task_.tool->cutting.r_max_mm, 1e-3));
  return std::max(programmed, angle);
}

// For lead and side tilts the directions of tilt follow the feed and also turn about the axis. Tilts of different
// positions are then not comparable.
double TiltSpace::largest_change_rad(std::size_t i) const {
  if (task_.options.freedom != TiltFreedom::both) return std::numeric_limits<double>::infinity();
  const double programmed = angle_between_rad(positions_[i].programmed.axis, positions_[i + 1].programmed.axis);
  const double most = task_.options.max_tilt_rad;
  return (largest_turn_rad(i, i + 1) + programmed) * (most > 0 ? most / std::sin(most) : 1) + kSure_rad;
}

bool TiltSpace::is_free_between(std::size_t i, const Tilt& from, std::size_t k, const Tilt& to) const {
  const auto is_untilted = [](const Tilt& tilt) { return !(tilt.norm() > 0); };
  if (is_untilted(from) && is_untilted(to)) {
    const auto first = positions_.begin() + static_cast<std::ptrdiff_t>(i),
               last = first + static_cast<std::ptrdiff_t>(k - i);
    return std::all_of(first + 1, last + 1, [](const TiltPosition& p) { return p.is_reached_clean; });
  }
  const std::optional<Pose> start = pose(i, from), end = pose(k, to);
  if (!start || !end) return false;
  const Motion motion = task_.checker->options().law.straight(*start, *end);
  if (!motion.is_defined() || motion.turn_rad() > largest_turn_rad(i, k) || !stays_within_limits(i, *start, k, *end))
    return false;
  return std::ranges::any_of(std::array{kMotionAimShare, kMaxShare}, [&](double share) {
    return checker_at(k).is_clean(motion, positions_[k].kind, *task_.tool, options_for(share), true);
  });
}

MotionChecker TiltSpace::checker_at(std::size_t i) const {
  return task_.checker->for_move(positions_[i].origin, false).searching();
}

/// Returns whether the programmed position is deeper than any motion that is certified clean.
bool TiltSpace::is_gouge(std::size_t i, MoveKind kind) const {
  CheckOptions options = options_for(1);
  options.tolerance_mm += options.resolution_mm + Tolerance::kWitness_mm;
  options.gouge_gap_mm = kAnyGap_mm;
  const Motion stays = options.law.at(positions_[i].programmed);
  return task_.checker->check(stays, kind, *task_.tool, options, true).state == MoveState::gouge;
}

bool TiltSpace::may_stay_programmed(std::size_t i) const {
  return positions_[i].is_fixed() ? positions_[i].stays_programmed() : is_free(i, Tilt::Zero());
}

// Programmed motions are not checked again (is_free_between), because tilts do not affect a gouge of the cutter alone.
bool TiltSpace::holds_back(std::size_t i) const {
  if (!positions_[i].stays_programmed()) return false;
  const auto is_open = [&](std::size_t from, std::size_t neighbour) {
    const TiltPosition& to = positions_[from + 1];
    return !is_gouge(i, to.kind) || (to.is_reached_clean && may_stay_programmed(neighbour));
  };
  return (i > 0 && !is_open(i - 1, i - 1)) || (i + 1 < size() && !is_open(i, i + 1));
}

MoveVerdict TiltSpace::verdict(std::size_t i, const Tilt& tilt) const {
  const std::optional<Pose> at = pose(i, tilt);
  return checker_at(i).measure(at.value_or(positions_[i].programmed), positions_[i].kind, *task_.tool);
}

bool TiltProofs::is_free(std::size_t i, const Tilt& tilt) {
  if (free_at_[i] == tilt) return true;
  if (!space_.is_free(i, tilt)) return false;
  free_at_[i] = tilt;
  return true;
}

bool TiltProofs::is_free_after(std::size_t i, const Tilt& from, const Tilt& to) {
  auto& known = free_after_[i];
  if (known && known->first == from && known->second == to) return true;
  if (!space_.is_free_between(i, from, i + 1, to)) return false;
  known = {from, to};
  return true;
}

}  // namespace gouge

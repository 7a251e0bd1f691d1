#include "postproc/gcode/running/program_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "lib/base/tolerance.h"
#include "lib/base/units.h"
#include "lib/machine/law_facts.h"
#include "lib/path/path_info.h"
#include "postproc/gcode/language/gcode_block.h"

namespace gouge {
namespace {

// Angles that differ by less are one position of a joint: rounding of degrees to radians.
constexpr double kSameAngle_rad = Tolerance::kExactDirection;

bool is_complete(const Vec3& xyz) { return !xyz.hasNaN(); }

bool is_same_angle(double a, double b) { return std::abs(a - b) <= kSameAngle_rad; }

bool turns(const AxisPlace& from, const AxisPlace& to) {
  if (from.axis && to.axis) return !from.axis->isApprox(*to.axis, kSameAngle_rad);
  for (std::size_t k = 0; k < 2; ++k) {
    const bool is_unknown_alike = !is_known(from.angles[k]) && !is_known(to.angles[k]);
    if (!is_unknown_alike && !is_same_angle(from.angles[k], to.angles[k])) return true;
  }
  return false;
}

/// Returns the scale of a map that keeps the shape of circles, negative for one that mirrors; none: it does not.
std::optional<double> arc_scale(const Eigen::Matrix3d& linear) {
  const Eigen::Matrix3d square = linear.transpose() * linear;
  const double scale = std::sqrt(square.trace() / 3);
  const Eigen::Matrix3d off = square / (scale * scale) - Eigen::Matrix3d::Identity();
  if (!(scale > 0) || !(off.cwiseAbs().maxCoeff() <= Tolerance::kRounding)) return std::nullopt;
  return linear.determinant() < 0 ? -scale : scale;
}

}  // namespace

ProgramMotion::ProgramMotion(PathBuilder& builder, const ProgramSetup& setup)
    : builder_(builder),
      setup_(setup),
      mapper_(setup.machine.get(), setup.control),
      chain_(builder),
      operation_(builder),
      has_run_(builder.path.statements.size()) {
  if (mapper_.has_machine())
    joints_ = std::make_shared<JointPath>();
  else
    place_.angles = {0, 0};
}

const AxisMap& ProgramMotion::map_at(const RotaryAngles& angles) {
  const auto is_same = [](double a, double b) { return std::abs(a - b) <= 0 || (std::isnan(a) && std::isnan(b)); };
  if (!is_map_current_ || !is_same(angles[0], map_angles_[0]) || !is_same(angles[1], map_angles_[1])) {
    map_ = mapper_.map(state_, angles);
    map_angles_ = angles;
    is_map_current_ = true;
  }
  return map_;
}

// An axis that the program states does not change how coordinates lead to the tip.
const AxisMap& ProgramMotion::map_at(const AxisPlace& place) {
  return map_at(place.axis ? RotaryAngles{0, 0} : place.angles);
}

const std::string* ProgramMotion::first_doubt() const {
  for (const std::string& one : doubts_)
    if (!one.empty()) return &one;
  return nullptr;
}

ProgramMotion::Reached ProgramMotion::reached(const AxisPlace& to) {
  const AxisMap& map = map_at(to);
  const bool has_lost_angles = !lost_angles_.empty() && !has_axis(to);
  if (!map.open.empty()) return {{}, has_lost_angles ? lost_angles_ : map.open};
  if (!is_complete(to.xyz))
    return {{},
            chain_.last_pose() ? "the place of the tool is not known"
            : !lost_place_.empty()
                ? lost_place_
                : "the place of the tool is not known at the start or after a tool change; expected X, "
                  "Y and Z in its first position"};
  if (to.axis && std::abs(state_.excess_length_mm) > 0)
    return {{}, "the length that is applied is not that of the tool, whose axis the program states"};
  if (state_.is_length_in_offset && length_needed_line_ == 0 && mapper_.needs_applied_length(state_, to.angles))
    length_needed_line_ = line_;
  if (to.axis) return {{map.tip(to.xyz), *to.axis}, {}};
  return {{map.tip(to.xyz), map.axis}, {}};
}

// What is not known of the motion itself, where both ends are known.
std::string ProgramMotion::why_not_motion(MoveKind kind, const AxisPlace& to, bool is_arc) const {
  if (!mapper_.has_machine()) {
    const Vec3 way = to.xyz - place_.xyz;
    const auto axes = (way.array().abs() > Tolerance::kRounding_mm).count();
    const bool is_open =
        kind == MoveKind::rapid && axes > 1 && !are_rapids_together_ && !setup_.are_joint_rapids_straight;
    return is_open ? "nothing states how several axes run in a rapid; expected --joint-rapid-law joint, or --machine"
                   : "";
  }
  const bool is_turning = turns(place_, to);
  if (is_turning && state_.tip_control == TipControl::turned_offset)
    return "rotary joints turn while the work offset follows them";
  if (is_turning && state_.is_aligned) return "rotary joints turn in a tilted frame";
  if ((is_turning || has_turned_) && !turn_doubt_.empty()) return turn_doubt_;
  if (is_turning && runs_without_tip_control(kind))
    return "tool centre point control is on, and the check runs by a law without it; expected --feed-law or --rapid-law "
           "vector, axis, documented or any";
  if (is_turning && turns_beyond_law(kind, to))
    return "a rotary joint turns by half a turn or more, which the law vector leaves out; expected --feed-law or "
           "--rapid-law axis, documented or any";
  if (is_turning && state_.tip_control == TipControl::unknown) return mapper_.unknown_tip_control();
  if (is_turning && is_arc && state_.tip_control != TipControl::on)
    return "rotary joints turn along an arc without tool centre point control";
  const bool has_no_angles = !to.axis && (!is_known(to.angles[0]) || !is_known(to.angles[1]));
  if (has_no_angles && kind == MoveKind::rapid && !setup_.are_joint_rapids_straight && !are_rapids_together_)
    return mapper_.unknown_angles();
  return {};
}

void ProgramMotion::store_angles(const Move& move, const AxisPlace& to) {
  if (joints_ == nullptr) return;
  const auto known = [](const RotaryAngles& angles) {
    return is_known(angles[0]) && is_known(angles[1]) ? std::optional(angles) : std::nullopt;
  };
  joints_->start.push_back(move.has_start && !joints_->end.empty() ? joints_->end.back() : std::nullopt);
  joints_->end.push_back(known(to.angles));
}

void ProgramMotion::add(Move& move, const AxisPlace& to, const Reached& reached, std::string reason) {
  Toolpath& path = builder_.path;
  move.line = line_;
  move.statement = statement_;
  move.tool = tool_;
  move.operation = operation_.resolve();
  move.set_feed(move.kind == MoveKind::rapid ? Feed{0, FeedUnit::rapid} : feed_);
  move.spindle_rpm = is_spindle_stopped_ || is_speed_zero_ ? Move::kSpindleStopped : spindle_rpm_;
  move.runs_joints = mapper_.has_machine() && state_.tip_control != TipControl::on;
  move.has_start = chain_.last_pose().has_value();
  const char* const unknown_start = chain_.unknown_start();
  const bool is_end_known = reached.open.empty();
  move.end = is_end_known ? reached.pose : chain_.last_pose().value_or(Pose{});
  if (!is_end_known && reason.empty()) reason = reached.open;
  if (reason.empty() && unknown_start != nullptr && move.has_start) reason = unknown_start;
  if (!reason.empty()) {
    move.not_checked_reason = lasting_text(std::move(reason));
    move.curve_kind = CurveKind::none;
    if (move.kind == MoveKind::arc) move.kind = MoveKind::feed;
  }
  if (mapper_.has_machine() && to.axis && move.not_checked_reason.empty()) unknown_angles_.add(line_);
  AxisPlace stored = to;
  if (!is_end_known) stored.angles = {AxisPlace::kUnknownCoordinate, AxisPlace::kUnknownCoordinate};
  store_angles(move, stored);
  if (is_end_known) {
    chain_.advance(move, nullptr);
  } else {
    chain_.stand(move.end, lasting_text("the place at which the motion begins is not known"));
  }
  builder_.make_room(path.moves);
  path.moves.push_back(move);
  if (moves_per_minute_ && move.kind != MoveKind::rapid && move.has_start && move.not_checked_reason.empty()) {
    const double feed_mm = move_length_mm(path, path.moves.size() - 1) * *moves_per_minute_;
    if (feed_mm > 0) path.moves.back().set_feed({feed_mm, FeedUnit::per_minute});
  }
  note_turn(to);
  if (state_.is_aligned && turns(place_, to)) {
    state_.is_aligned = false;
    is_map_current_ = false;
  }
  if (is_end_known) has_unknown_step_ = false;
  place_ = to;
}

bool ProgramMotion::has_axis(const AxisPlace& to) const {
  return state_.is_aligned || to.axis || (is_known(to.angles[0]) && is_known(to.angles[1]));
}

// The approach after a tool change, or at the start: no position is known yet, as before the first one of CL data. Before a
// height is stated the tool is at that of the tool change; then the check compares the height with the parts.
bool ProgramMotion::is_approach(MoveKind kind, const AxisPlace& to) const {
  const bool is_reached = is_complete(to.xyz) && has_axis(to);
  return kind == MoveKind::rapid && !chain_.last_pose() && !has_unknown_step_ && !is_reached;
}

// Notes the height of a rapid from a place that is not known. Where rotary joints are not known, or Z is not along the
// tool, that of an incomplete place is not known.
void ProgramMotion::note_height(const AxisPlace& to) {
  if (!is_known(to.xyz.z())) return;
  const AxisMap& map = map_at(to);
  const bool is_axis_known = has_axis(to);
  if (is_axis_known && !map.open.empty()) return;
  if (is_axis_known && is_complete(to.xyz)) {
    const Vec3& axis = to.axis ? *to.axis : map.axis;
    builder_.path.approaches.push_back({line_, axis, axis.dot(map.tip(to.xyz))});
    return;
  }
  constexpr double kSquare = Tolerance::kExactDirection;
  const bool is_level =
      std::abs(map.axis.dot(map.linear.col(0))) < kSquare && std::abs(map.axis.dot(map.linear.col(1))) < kSquare;
  const bool is_height = is_axis_known && is_level && !to.axis;
  const double height = map.axis.dot(map.origin) + map.axis.dot(map.linear.col(2)) * to.xyz.z();
  builder_.path.approaches.push_back({line_, map.axis, is_height ? height : -std::numeric_limits<double>::infinity()});
}

// Where the control rounds the turns of rotary joints, it does so in the moves beside them too.
void ProgramMotion::note_turn(const AxisPlace& to) {
  Moves& moves = builder_.path.moves;
  if (has_turned_ || !mapper_.has_machine() || moves.size() < 2 || !moves.back().has_start || !turns(place_, to))
    return;
  has_turned_ = true;
  Move& before = moves[moves.size() - 2];
  if (!turn_doubt_.empty() && before.has_start && before.not_checked_reason.empty())
    before.not_checked_reason = lasting_text(turn_doubt_);
}

std::optional<TurnLaw> ProgramMotion::law_of_tip_control(MoveKind kind) const {
  if (!setup_.laws || state_.tip_control != TipControl::on) return std::nullopt;
  return kind == MoveKind::rapid ? setup_.laws->rapids : setup_.laws->feeds;
}

/// The laws joint and independent are those of joints without tool centre point control.
bool ProgramMotion::runs_without_tip_control(MoveKind kind) const {
  const std::optional<TurnLaw> law = law_of_tip_control(kind);
  return law && runs_joints(*law);
}

/// On the great circle the tool axis takes the shorter way between its ends.
bool ProgramMotion::turns_beyond_law(MoveKind kind, const AxisPlace& to) const {
  if (law_of_tip_control(kind) != TurnLaw::vector) return false;
  constexpr double kHalfTurn_rad = std::numbers::pi - Tolerance::kExactDirection;
  const auto is_wide = [&](std::size_t k) { return std::abs(to.angles.at(k) - place_.angles.at(k)) >= kHalfTurn_rad; };
  return is_wide(0) || is_wide(1);
}

void ProgramMotion::go_unchecked(MoveKind kind, const AxisPlace& to, const std::string& reason) {
  const std::string* const doubtful = first_doubt();
  const Reached end = doubtful != nullptr ? Reached{{}, *doubtful} : reached(to);
  if (doubtful == nullptr && is_approach(kind, to)) {
    if (lost_place_.empty()) lost_place_ = reason;
    return leave_out(to);
  }
  Move move;
  move.kind = kind;
  add(move, to, end, doubtful != nullptr ? *doubtful : reason);
}

void ProgramMotion::leave_out(const AxisPlace& to) {
  approach_.add(line_);
  note_height(to);
  place_ = to;
}

void ProgramMotion::go(MoveKind kind, const AxisPlace& to) {
  if (first_doubt() != nullptr) return go_unchecked(kind, to, {});
  const Reached end = reached(to);
  if (is_approach(kind, to)) return leave_out(to);
  if (kind == MoveKind::rapid && !chain_.last_pose()) note_height(to);
  Move move;
  move.kind = kind;
  const bool has_start = chain_.last_pose().has_value();
  const bool is_feed_from_nowhere = !has_start && kind != MoveKind::rapid && end.open.empty();
  add(move, to, end,
      has_start              ? why_not_motion(kind, to, false)
      : is_feed_from_nowhere ? "the place at which the feed begins is not known; expected a rapid with all coordinates"
                             : std::string());
}

void ProgramMotion::go_round(const AxisPlace& to, const ProgramArc& arc) {
  if (const std::string* const doubtful = first_doubt()) return go_unchecked(MoveKind::arc, to, *doubtful);
  const Reached end = reached(to);
  Move move;
  move.kind = MoveKind::arc;
  std::string reason = why_not_motion(MoveKind::arc, to, true);
  const AxisMap& map = map_at(to);
  const auto scale = arc_scale(map.linear);
  if (reason.empty() && !scale) reason = "the frame scales the axes of an arc differently";
  if (reason.empty() && end.open.empty() && chain_.last_pose()) {
    // A mirrored frame turns the arc the other way about the image of its axis.
    PathArc made{map.tip(arc.centre), (map.linear * arc.axis).normalized() * (*scale < 0 ? -1 : 1), arc.sweep_rad};
    builder_.make_room(builder_.path.arcs);
    move.curve = builder_.path.arcs.size();
    move.curve_kind = CurveKind::arc;
    builder_.path.arcs.push_back(made);
  }
  if (reason.empty() && !chain_.last_pose()) reason = "the place at which the arc begins is not known";
  add(move, to, end, std::move(reason));
}

void ProgramMotion::finish() {
  if (joints_ != nullptr) builder_.path.joints = joints_;
  chain_.write_note();
  builder_.report(
      Severity::warning, "gcode-joints", unknown_angles_, "move",
      " with the tool axis as a vector: the positions of the rotary joints, and their limits, are not known");
  builder_.report(Severity::note, "gcode-approach", approach_, "rapid",
                  " before all coordinates of the tool are known: nothing is swept there");
}

}  // namespace gouge

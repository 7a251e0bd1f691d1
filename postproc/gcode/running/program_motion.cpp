#include "postproc/gcode/running/program_motion.h"

#include <algorithm>
#include <cmath>

#include "lib/base/tolerance.h"
#include "lib/base/units.h"
#include "lib/path/path_info.h"
#include "postproc/gcode/language/gcode_block.h"

namespace gouge {
namespace {

// Angles that differ by less are one position of a joint: rounding of degrees to radians.
constexpr double kSameAngle_rad = Tolerance::kExactDirection;

bool is_complete(const Vec3& xyz) { return !xyz.hasNaN(); }

bool is_same_angle(double a, double b) { return std::abs(a - b) <= kSameAngle_rad; }

bool turns(const AxisPlace& from, const AxisPlace& to) {
  for (std::size_t k = 0; k < 2; ++k) {
    const bool is_unknown_alike = !is_known(from.angles[k]) && !is_known(to.angles[k]);
    if (!is_unknown_alike && !is_same_angle(from.angles[k], to.angles[k])) return true;
  }
  return false;
}

}  // namespace

ProgramMotion::ProgramMotion(PathBuilder& builder, const ProgramSetup& setup)
    : builder_(builder), setup_(setup), mapper_(setup.machine.get()), chain_(builder), operation_(builder) {
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

// The machine stands while a frame or a length changes: the tip keeps its place, and the coordinates become others.
template <typename Change>
void ProgramMotion::change_state(const Change& change) {
  const AxisMap before = map_at(place_.angles);
  const std::string& offset_doubt = doubts_[static_cast<std::size_t>(ProgramDoubt::offset)];
  const bool is_doubtful = !before.open.empty() || !offset_doubt.empty();
  change();
  is_map_current_ = false;
  const AxisMap& after = map_at(place_.angles);
  Vec3& xyz = place_.xyz;
  const bool is_known_now = !is_doubtful && after.open.empty() && offset_doubt.empty();
  const bool is_same_map = before.linear == after.linear && before.origin == after.origin;
  if (is_known_now && is_same_map) return;
  if (is_known_now && is_complete(xyz)) {
    xyz = after.coordinates(before.tip(xyz));
  } else if (is_known_now && (after.linear - before.linear).cwiseAbs().maxCoeff() <= Tolerance::kExactDirection) {
    xyz += after.linear.partialPivLu().solve(Vec3(before.origin - after.origin));  // each coordinate apart
  } else {
    xyz.setConstant(AxisPlace::kUnknownCoordinate);
    chain_.lose_last_pose(lasting_text("the place of the tool is not known when the frame or the length changes"));
  }
}

void ProgramMotion::doubt(ProgramDoubt kind, std::string reason) {
  std::string& own = doubts_.at(static_cast<std::size_t>(kind));
  if (kind != ProgramDoubt::rest || own.empty()) own = std::move(reason);
}

void ProgramMotion::end_doubt(ProgramDoubt kind) {
  std::string& own = doubts_.at(static_cast<std::size_t>(kind));
  if (own.empty()) return;
  own.clear();
  // Frames and compensation that end leave the tool at a place that they alone knew.
  if (kind == ProgramDoubt::frame || kind == ProgramDoubt::compensation)
    place_.xyz.setConstant(AxisPlace::kUnknownCoordinate);
  chain_.lose_last_pose(lasting_text("the place at which the motion begins is not known"));
}

void ProgramMotion::choose_offset(const std::string& name) {
  if (name == offset_name_) return;
  if (part_offset_.empty()) part_offset_ = name;
  const auto found = setup_.offsets.find(name), of_part = setup_.offsets.find(part_offset_);
  const bool is_given = found != setup_.offsets.end();
  const auto shift_of = [&](const WorkOffset& offset) {
    // Without a part zero, the part is at the offset that the program chooses first.
    return Vec3(setup_.zero || of_part == setup_.offsets.end() ? offset.xyz_mm
                                                               : offset.xyz_mm - of_part->second.xyz_mm);
  };
  const bool is_part_known = setup_.zero || of_part != setup_.offsets.end();
  const bool is_open = name != part_offset_ && (!is_given || !is_part_known);
  change_state([&] {
    offset_name_ = name;
    state_.shift_mm = is_given ? shift_of(found->second) : setup_.zero ? setup_.zero->shift : Vec3(Vec3::Zero());
    if (is_open)
      doubt(ProgramDoubt::offset, "the program changes from work offset " + part_offset_ + " to " + name +
                                      ", whose places are not given; expected --offset " + part_offset_ +
                                      "=X,Y,Z and --offset " + name + "=X,Y,Z");
    else
      end_doubt(ProgramDoubt::offset);
  });
  RotaryAngles shift{};
  for (const char letter : {'A', 'B', 'C'}) {
    const auto k = mapper_.rotary_of(letter);
    if (k && is_given) shift.at(*k) = found->second.abc_deg[letter - 'A'] * kDegree_rad;
  }
  angle_shift_ = shift;
}

double ProgramMotion::angle_from_program(std::size_t rotary, double degrees) const {
  return degrees * kDegree_rad + angle_shift_.at(rotary);
}

Vec3 ProgramMotion::from_machine(const Vec3& machine_mm) const {
  const auto found = setup_.offsets.find(offset_name_);
  const bool is_shifted = state_.plane || !doubts_[static_cast<std::size_t>(ProgramDoubt::offset)].empty() ||
                          (state_.tip_control != TipControl::off && mapper_.has_machine());
  if (is_shifted) return Vec3::Constant(AxisPlace::kUnknownCoordinate);
  const bool is_given = found != setup_.offsets.end();
  if (!is_given && !setup_.zero) return Vec3::Constant(AxisPlace::kUnknownCoordinate);
  Vec3 xyz = machine_mm - (is_given ? found->second.xyz_mm : setup_.zero->shift);
  if (length_ == Length::applied)
    xyz.z() -= length_of(length_number_ ? length_number_ : tool_number()).value_or(AxisPlace::kUnknownCoordinate);
  return xyz;
}

std::optional<int> ProgramMotion::tool_number() const {
  return tool_ == kNone ? std::nullopt : builder_.path.tools[tool_].number;
}

std::optional<double> ProgramMotion::length_of(std::optional<int> number) const {
  if (number) {
    const auto found = setup_.lengths_mm.find(*number);
    if (found != setup_.lengths_mm.end()) return found->second;
  }
  return setup_.tool_length_mm;
}

void ProgramMotion::set_tip_control(TipControl control) {
  if (state_.tip_control == control) return;
  change_state([&] { state_.tip_control = control; });
}

void ProgramMotion::set_plane(const std::optional<RigidTransform>& plane) {
  if (!plane && !state_.plane) return;
  change_state([&] {
    state_.plane = plane;
    state_.is_aligned = false;
  });
}

void ProgramMotion::align_to_plane() {
  if (!state_.plane) return doubt(ProgramDoubt::rest, "the tool is aligned with a tilted frame that is not set");
  AxisPlace to;
  go_unchecked(MoveKind::rapid, to, "the motion that aligns the tool with the tilted frame is not known");
  state_.is_aligned = true;
  is_map_current_ = false;
}

std::string ProgramMotion::why_sideways() const {
  for (const std::optional<int> number : {tool_number(), length_ == Length::none ? std::nullopt : length_number_}) {
    const auto found = number ? setup_.lengths_mm.find(*number) : setup_.lengths_mm.end();
    if (found != setup_.lengths_mm.end() && std::isnan(found->second))
      return "the tool table moves T" + std::to_string(*number) +
             " along or about other axes than Z, which is not read; expected offsets of Z alone in --tool-lengths";
  }
  return {};
}

// Finds the length that the control applies, and the true one. Where they are equal, neither need be known on a machine
// whose head does not turn: the program states the tip.
void ProgramMotion::settle_length() {
  const std::optional<int> tool = tool_number();
  const std::optional<double> true_length = length_of(tool);
  const std::string name = tool ? "T" + std::to_string(*tool) : "the tool";
  state_.tool_length_mm = true_length.value_or(0);
  state_.excess_length_mm = 0;
  state_.open_length = why_sideways();
  if (!state_.open_length.empty()) return;
  if (length_ == Length::none) {
    if (!has_lengths_) {
      if (tools_loaded_ > 1) state_.open_length = "the program changes the tool and applies no length; expected G43";
    } else if (true_length) {
      state_.excess_length_mm = -*true_length;
    } else {
      state_.open_length =
          "no tool length is applied, and that of " + name + " is not given; expected --tool-lengths or --tool-length";
    }
    return;
  }
  const bool needs_length = setup_.machine != nullptr && has_rotary_head(*setup_.machine);
  if (needs_length && !true_length && state_.tip_control == TipControl::off)
    state_.open_length = "the length of " + name + " is not given; expected --tool-lengths or --tool-length";
  if (!lost_length_.empty()) {
    state_.open_length = lost_length_;
    return;
  }
  // A tool change does not apply the length of the new tool.
  const std::optional<int> applied = length_number_;
  if (!applied && length_tool_ != tool_)
    state_.open_length = "the length that is applied is that of another tool; expected G43 after the tool change";
  if (!applied || applied == tool || !tool) return;
  const auto other = setup_.lengths_mm.find(*applied), own = setup_.lengths_mm.find(*tool);
  if (other == setup_.lengths_mm.end() || own == setup_.lengths_mm.end())
    state_.open_length = "H" + std::to_string(*applied) + " is applied to " + name +
                         ", and their lengths are not given; expected --tool-lengths";
  else
    state_.excess_length_mm = other->second - own->second;
}

void ProgramMotion::change_tool(const PathTool& tool) {
  if (tool_ == kNone || builder_.path.tools[tool_].number != tool.number) ++tools_loaded_;
  const auto same =
      std::ranges::find_if(builder_.path.tools, [&](const PathTool& one) { return one.number == tool.number; });
  tool_ = static_cast<std::size_t>(same - builder_.path.tools.begin());
  if (same == builder_.path.tools.end()) builder_.path.tools.push_back(tool);
  chain_.break_off();
  chain_.note_loading();
  place_.xyz.setConstant(AxisPlace::kUnknownCoordinate);
  settle_length();
  is_map_current_ = false;
}

void ProgramMotion::apply_length(std::optional<int> h) {
  if (!has_lengths_ && chain_.last_pose())
    doubt(ProgramDoubt::rest, "a tool length is applied in a program that is called, and positions before it had none");
  has_lengths_ = true;
  if (h && *h == 0) return cancel_length();
  change_state([&] {
    length_ = Length::applied;
    length_number_ = h ? h : tool_number();
    lost_length_.clear();
    length_tool_ = tool_;
    settle_length();
  });
}

void ProgramMotion::cancel_length() {
  change_state([&] {
    length_ = Length::none;
    length_number_.reset();
    lost_length_.clear();
    settle_length();
  });
}

void ProgramMotion::lose_length(const std::string& reason) {
  if (length_ == Length::none) return;
  change_state([&] {
    lost_length_ = reason;
    settle_length();
  });
}

const std::string* ProgramMotion::first_doubt() const {
  for (const std::string& one : doubts_)
    if (!one.empty()) return &one;
  return nullptr;
}

ProgramMotion::Reached ProgramMotion::reached(const AxisPlace& to) {
  const AxisMap& map = map_at(to.angles);
  if (!map.open.empty()) return {{}, map.open};
  if (!is_complete(to.xyz)) return {{}, "the place of the tool is not known"};
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
  if (is_turning && state_.tip_control == TipControl::unknown)
    return "nothing states whether tool centre point control is on";
  if (is_turning && is_arc && state_.tip_control != TipControl::on)
    return "rotary joints turn along an arc without tool centre point control";
  const bool has_no_angles = !is_known(to.angles[0]) || !is_known(to.angles[1]);
  if (has_no_angles && kind == MoveKind::rapid && !setup_.are_joint_rapids_straight && !are_rapids_together_)
    return "the positions of the rotary joints are not known";
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
  place_ = to;
}

// The approach after a tool change, or at the start: no position is known yet, as before the first one of CL data.
bool ProgramMotion::is_approach(MoveKind kind, const Reached& end) const {
  return kind == MoveKind::rapid && !end.open.empty() && !chain_.last_pose();
}

void ProgramMotion::go_unchecked(MoveKind kind, const AxisPlace& to, const std::string& reason) {
  const std::string* const doubtful = first_doubt();
  const Reached end = doubtful != nullptr ? Reached{{}, *doubtful} : reached(to);
  if (doubtful == nullptr && is_approach(kind, end)) return approach(to);
  Move move;
  move.kind = kind;
  add(move, to, end, doubtful != nullptr ? *doubtful : reason);
}

void ProgramMotion::approach(const AxisPlace& to) {
  approach_.add(line_);
  place_ = to;
}

void ProgramMotion::go(MoveKind kind, const AxisPlace& to) {
  if (first_doubt() != nullptr) return go_unchecked(kind, to, {});
  const Reached end = reached(to);
  if (is_approach(kind, end)) return approach(to);
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
  const AxisMap& map = map_at(to.angles);
  if (reason.empty() && map.linear.determinant() < 0) reason = "the axes X, Y and Z of the machine are left-handed";
  if (reason.empty() && end.open.empty() && chain_.last_pose()) {
    PathArc made{map.tip(arc.centre), (map.linear * arc.axis).normalized(), arc.sweep_rad};
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
  builder_.report(Severity::note, "gcode-approach", approach_, "rapid",
                  " before all coordinates of the tool are known: nothing is swept there");
}

}  // namespace gouge

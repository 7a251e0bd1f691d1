// The state of a program: work offset, tool centre point control, frames, tools and their lengths.

#include <algorithm>
#include <cmath>
#include <utility>

#include "lib/base/tolerance.h"
#include "lib/base/units.h"
#include "postproc/gcode/language/gcode_block.h"
#include "postproc/gcode/running/program_motion.h"
#include "postproc/gcode/running/program_text.h"

namespace gouge {
namespace {

/// Returns linear * x, where a row that does not depend on an unknown coordinate stays known.
Vec3 apply_known(const Eigen::Matrix3d& linear, const Vec3& x) {
  Vec3 y = Vec3::Zero();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (std::abs(linear(i, j)) > 0) y[i] += linear(i, j) * x[j];
  return y;
}

}  // namespace

// The machine stands while a frame or a length changes: the tip keeps its place, and the coordinates become others.
template <typename Change>
void ProgramMotion::change_state(const Change& change) {
  const AxisMap before = map_at(place_);
  const std::string& offset_doubt = doubts_[static_cast<std::size_t>(ProgramDoubt::offset)];
  const bool is_doubtful = !before.open.empty() || !offset_doubt.empty();
  change();
  is_map_current_ = false;
  const AxisMap& after = map_at(place_);
  Vec3& xyz = place_.xyz;
  if (is_doubtful && chain_.is_start_certain() && after.open.empty() && offset_doubt.empty()) {
    xyz = after.coordinates(chain_.last_pose()->tip);
    return;
  }
  const bool is_known_now = !is_doubtful && after.open.empty() && offset_doubt.empty();
  const auto may_be_along_z = [](const AxisMap& map) { return map.open.empty() || map.is_open_along_z; };
  const bool is_turned_alike = (after.linear - before.linear).cwiseAbs().maxCoeff() <= Tolerance::kExactDirection;
  const bool is_same_map = before.linear == after.linear && before.origin == after.origin;
  if (is_known_now && is_same_map) return;
  if (is_known_now && !xyz.hasNaN()) {
    xyz = after.coordinates(before.tip(xyz));
  } else if (is_known_now && is_turned_alike) {
    xyz += after.linear.partialPivLu().solve(Vec3(before.origin - after.origin));  // each coordinate apart
  } else if (is_turned_alike && may_be_along_z(before) && may_be_along_z(after) && offset_doubt.empty() &&
             why_sideways().empty()) {
    // A length that is not known leaves the coordinates across it.
    xyz += after.linear.partialPivLu().solve(Vec3(before.origin - after.origin));
    xyz.z() = AxisPlace::kUnknownCoordinate;
    if (is_doubtful) chain_.lose_last_pose(lasting_text("the place of the tool is not known when the length changes"));
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

// A program that has no position yet takes its part along. Coordinates that it has stated stay where they are in the machine.
void ProgramMotion::move_part_to(const std::string& name) {
  const auto from = setup_.offsets.find(offset_name_), to = setup_.offsets.find(name);
  part_offset_ = name;
  if (from != setup_.offsets.end() && to != setup_.offsets.end()) {
    if (!setup_.zero) state_.shift_mm = from->second.xyz_mm - to->second.xyz_mm;
    is_map_current_ = false;
    return;
  }
  const std::string reason = "the program changes from work offset " + offset_name_ + " to " + name + in_line(line_) +
                             ", and coordinates before it are those of " + offset_name_ +
                             "; expected them again after the change, or --offset " + offset_name_ +
                             "=X,Y,Z and --offset " + name + "=X,Y,Z";
  const Vec3& xyz = place_.xyz;
  if (is_known(xyz.x()) || is_known(xyz.y()) || is_known(xyz.z())) lost_place_ = reason;
  place_.xyz.setConstant(AxisPlace::kUnknownCoordinate);
  if (!mapper_.has_machine()) return;
  place_.axis.reset();
  for (std::size_t k = 0; k < 2; ++k) {
    if (is_angle_of_machine_.at(k) || !is_known(place_.angles.at(k))) continue;
    place_.angles.at(k) = AxisPlace::kUnknownCoordinate;
    lost_angles_ = offset_name_.empty() ? "rotary joints are stated before work offset " + name + in_line(line_) +
                                              "; expected them after it, or --start " + name
                                        : reason;
  }
}

void ProgramMotion::choose_offset(const std::string& name) {
  if (name == offset_name_) return;
  const bool has_position = !builder_.path.moves.empty() || !builder_.path.approaches.empty();
  if (part_offset_.empty() || !has_position) move_part_to(name);
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
    settle_length();
  });
  RotaryAngles shift{};
  for (const char letter : {'A', 'B', 'C'}) {
    const auto k = mapper_.rotary_of(letter);
    if (k && is_given) shift.at(*k) = found->second.abc_deg[letter - 'A'] * kDegree_rad;
  }
  angle_shift_ = shift;
}

bool ProgramMotion::has_turned_offset() const {
  return mapper_.has_machine() && std::ranges::any_of(angle_shift_, [](double shift) { return std::abs(shift) > 0; });
}

double ProgramMotion::angle_from_program(std::size_t rotary, double degrees) {
  is_angle_of_machine_.at(rotary) = line_ == 0;
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

bool ProgramMotion::is_offset_given() const { return setup_.offsets.contains(offset_name_) || setup_.zero.has_value(); }

Vec3 ProgramMotion::from_machine_axes(const Vec3& axes_mm) const {
  const bool is_of_joints = state_.tip_control == TipControl::off || !mapper_.has_machine();
  const bool is_open = state_.plane || !is_of_joints || !is_offset_given() ||
                       !doubts_[static_cast<std::size_t>(ProgramDoubt::offset)].empty() ||
                       !doubts_[static_cast<std::size_t>(ProgramDoubt::frame)].empty();
  if (is_open) return Vec3::Constant(AxisPlace::kUnknownCoordinate);
  const auto found = setup_.offsets.find(offset_name_);
  const ProgramFrame frame = state_.frame.value_or(ProgramFrame{});
  const Vec3 origin = frame.shift + (found != setup_.offsets.end() ? found->second.xyz_mm : setup_.zero->shift);
  // The axes at which the tool stands now, as far as they are known.
  Vec3 axes = apply_known(frame.linear, place_.xyz) + origin;
  for (int i = 0; i < 3; ++i)
    if (is_known(axes_mm[i])) axes[i] = axes_mm[i];
  return apply_known(frame.linear.inverse(), Vec3(axes - origin));
}

std::optional<Vec3> ProgramMotion::direction_in_part(const Vec3& direction) {
  const AxisMap& map = map_at(RotaryAngles{0, 0});
  const auto scale = arc_scale(map.linear);
  if (!map.open.empty() || !scale || *scale < 0 || !(direction.norm() > 0)) return std::nullopt;
  return Vec3(map.linear * direction).normalized();
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

// A negative length is measured from another point, such as the tip of another tool, and so are all lengths with it. Their
// differences stay right.
std::optional<double> ProgramMotion::gauge_length_of(std::optional<int> number) const {
  const std::map<int, double>& lengths = setup_.lengths_mm;
  const bool is_relative = number && lengths.contains(*number) &&
                           std::ranges::any_of(lengths, [](const auto& length) { return length.second < 0; });
  return is_relative ? std::nullopt : length_of(number);
}

std::string ProgramMotion::why_no_gauge_length() const {
  const std::optional<int> tool = tool_number();
  if (!tool || !length_of(tool)) return " is not given; expected --tool-lengths or --tool-length";
  return " is not known, because --tool-lengths has a negative length; expected lengths from the gauge point of the "
         "spindle to the tip";
}

void ProgramMotion::set_tip_control(TipControl control) {
  if (state_.tip_control == control) return;
  change_state([&] {
    state_.tip_control = control;
    place_.axis.reset();  // the angles that it stands for are not known
    settle_length();
  });
}

void ProgramMotion::set_tip_frame(const RotaryAngles& angles) {
  if (state_.tip_frame == angles) return;
  change_state([&] {
    state_.tip_frame = angles;
    settle_length();
  });
}

void ProgramMotion::set_plane(const std::optional<RigidTransform>& plane) {
  if (!plane && !state_.plane) return;
  change_state([&] {
    state_.plane = plane;
    state_.is_aligned = false;
  });
}

void ProgramMotion::set_frame(const std::optional<ProgramFrame>& frame) {
  if (!frame && !state_.frame) return;
  change_state([&] { state_.frame = frame; });
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
  const std::optional<double> true_length = gauge_length_of(tool);
  const bool is_named = tool_ != kNone && !builder_.path.tools[tool_].name.empty();
  const std::string name = tool       ? "T" + std::to_string(*tool)
                           : is_named ? "tool " + builder_.path.tools[tool_].name
                                      : "the tool";
  state_.tool_length_mm = true_length.value_or(0);
  state_.excess_length_mm = 0;
  state_.is_length_in_offset = false;
  state_.open_length = why_sideways();
  if (!state_.open_length.empty()) return;
  if (length_ == Length::none) {
    // A part zero and an offset in machine coordinates leave no room for it.
    const bool is_offset_known = setup_.zero && setup_.offsets.contains(offset_name_);
    if (!has_lengths_ && !is_offset_known) {
      state_.is_length_in_offset = true;
      if (tools_loaded_ > 1) state_.open_length = "the program changes the tool and applies no length; expected G43";
    } else if (true_length) {
      state_.excess_length_mm = -*true_length;
    } else {
      state_.open_length = "no tool length is applied, and that of " + name + why_no_gauge_length();
    }
    return;
  }
  const bool needs_length = setup_.machine != nullptr && needs_true_length(*setup_.machine);
  if (needs_length && !true_length && state_.tip_control == TipControl::off)
    state_.open_length = "the length of " + name + why_no_gauge_length();
  if (!lost_length_.empty()) {
    state_.open_length = lost_length_;
    return;
  }
  // A tool change does not apply the length of the new tool.
  const std::optional<int> applied = length_number_;
  if (!applied && length_tool_ != tool_)
    state_.open_length = "the length that is applied is that of another tool; expected G43 after the tool change";
  const std::optional<int> of_tool = tool ? tool : first_length_number_;
  if (!applied || applied == of_tool) return;
  const auto other = setup_.lengths_mm.find(*applied), own = setup_.lengths_mm.find(*of_tool);
  if (other != setup_.lengths_mm.end() && own != setup_.lengths_mm.end()) {
    state_.excess_length_mm = other->second - own->second;
    return;
  }
  const std::string lengths = "H" + std::to_string(*applied) + " is applied to " + name;
  state_.open_length = tool ? lengths + ", and their lengths are not given; expected --tool-lengths"
                            : lengths + " after H" + std::to_string(*of_tool) +
                                  ", and no tool number is stated; expected T and M6 where the tool changes, or both "
                                  "lengths in --tool-lengths";
}

// A change may leave the spindle where it is, because no motion of the machine is certain. The tip of a longer tool is then
// lower.
void ProgramMotion::note_height_of_change(const PathTool& next) {
  const std::optional<Pose>& pose = chain_.last_pose();
  if (!chain_.is_start_certain() || !pose) return;
  double lower_mm = 0;
  const std::optional<double> before = gauge_length_of(tool_number()), after = gauge_length_of(next.number);
  if (before && after && *after > *before) lower_mm = *after - *before;
  builder_.path.approaches.push_back({line_, pose->axis, pose->axis.dot(pose->tip) - lower_mm});
}

// Adds the facts of the tool table that the program does not state.
void ProgramMotion::take_table(PathTool& tool) const {
  if (!tool.number) return;
  tool.in_table.file = setup_.tool_table;
  if (const auto corner = setup_.corners_mm.find(*tool.number); corner != setup_.corners_mm.end())
    tool.in_table.corner_mm = corner->second;
  const auto diameter = setup_.diameters_mm.find(*tool.number);
  if (diameter == setup_.diameters_mm.end() || tool.stated_diameter_mm > 0) return;
  tool.stated_diameter_mm = diameter->second;
  tool.in_table.has_diameter = true;
}

void ProgramMotion::change_tool(const PathTool& tool) {
  note_height_of_change(tool);
  if (tool.number) first_length_number_.reset();
  const auto is_same = [&](const PathTool& one) { return one.number == tool.number && one.name == tool.name; };
  if (tool_ == kNone || !is_same(builder_.path.tools[tool_])) ++tools_loaded_;
  const auto same = std::ranges::find_if(builder_.path.tools, is_same);
  tool_ = static_cast<std::size_t>(same - builder_.path.tools.begin());
  if (same == builder_.path.tools.end()) {
    builder_.path.tools.push_back(tool);
    PathTool& loaded = builder_.path.tools.back();
    const std::optional<double> length = gauge_length_of(tool.number);
    if (length && !std::isnan(*length)) loaded.gauge_length_mm = length;
    take_table(loaded);
  }
  chain_.break_off();
  has_unknown_step_ = false;
  lost_place_.clear();
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
    if (!tool_number() && !first_length_number_) first_length_number_ = h;
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

void ProgramMotion::run_by_machine(const std::function<void()>& run) {
  if (lost_length_.empty()) return run();
  const std::string lost = std::exchange(lost_length_, {});
  settle_length();
  is_map_current_ = false;
  const AxisMap& map = map_at(place_);
  if (map.open.empty() && chain_.is_start_certain()) place_.xyz = map.coordinates(chain_.last_pose()->tip);
  run();
  lost_length_ = lost;
  settle_length();
  is_map_current_ = false;
  place_.xyz.z() = AxisPlace::kUnknownCoordinate;
}

void ProgramMotion::lose_length(const std::string& reason) {
  if (length_ == Length::none) return;
  change_state([&] {
    lost_length_ = reason;
    settle_length();
  });
}

}  // namespace gouge

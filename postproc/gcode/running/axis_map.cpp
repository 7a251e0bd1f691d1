#include "postproc/gcode/running/axis_map.h"

#include <algorithm>
#include <cmath>

#include "lib/base/number_text.h"
#include "lib/base/tolerance.h"
#include "postproc/gcode/language/gcode_block.h"

namespace gouge {
namespace {

constexpr std::array<char, 3> kLinearNames = {'X', 'Y', 'Z'};

std::optional<std::size_t> joint_called(const Machine& machine, char letter) {
  for (std::size_t k = 0; k < machine.joints.size(); ++k)
    if (machine.joints[k].name.size() == 1 && machine.joints[k].name[0] == letter) return k;
  return std::nullopt;
}

bool stands_at_zero(double angle) { return std::abs(angle) <= Tolerance::kExactDirection; }

bool has_turned_tip_frame(const AxisFrame& state) {
  return state.tip_control == TipControl::on && !std::ranges::all_of(state.tip_frame, stands_at_zero);
}

}  // namespace

std::string describe_unfit(const Machine& machine) {
  if (!machine.control.unread_setting.empty())
    return "the configuration of machine " + machine.name + " states " + machine.control.unread_setting +
           ", which programs are not read by; expected a machine file in place of it";
  for (const char letter : kLinearNames) {
    const auto joint = joint_called(machine, letter);
    if (!joint || is_rotary(machine.joints[*joint]))
      return "machine " + machine.name + " has no linear joint " + std::string(1, letter);
  }
  for (const std::size_t k : machine.rotary) {
    const std::string& name = machine.joints[k].name;
    if (name != "A" && name != "B" && name != "C")
      return "machine " + machine.name + " has the rotary joint " + name + "; programs name A, B and C";
  }
  return {};
}

bool needs_true_length(const Machine& machine) {
  if (depends_on_tool_length(machine)) return true;
  const auto z = joint_called(machine, 'Z');
  const Vec3 along = machine.rest.rotation.col(2);
  return !z || (machine.joints[*z].direction - along).norm() > Tolerance::kExactDirection;
}

Diagnostic describe_missing_axis(char letter, const Machine* machine, const std::string& file, std::size_t line) {
  const std::string missing =
      machine != nullptr ? ", which machine " + machine->name + " does not have; expected the machine of this program"
                         : "; expected --machine, which states where this axis is";
  return make_error("gcode-machine", "the program turns axis " + std::string(1, letter) + missing, file, line);
}

std::string AxisMapper::unknown_angles() const {
  if (machine_ == nullptr) return "the positions of the rotary joints are not known";
  const bool is_klartext = control_ == "heidenhain", is_siemens = control_ == "siemens";
  std::vector<std::string> names;
  std::string words = is_klartext ? "L" : is_siemens ? "G71 G90 G60 G0" : "G90 G0";
  for (const std::size_t k : machine_->rotary) {
    names.push_back(machine_->joints[k].name);
    words += " " + names.back() + (is_klartext ? "+0" : is_siemens ? "0" : "0.");
  }
  return "the positions of the rotary joints are not known; expected " + listed(names, " and ") +
         " in a block before, or --start \"" + words + (is_klartext ? " FMAX" : "") + "\"" +
         (is_siemens ? ", with G70 for a program in inches" : "");
}

std::string AxisMapper::unknown_tip_control() const {
  const std::string text = "nothing states whether tool centre point control is on";
  return control_ == "siemens" ? text + "; expected TRAORI or TRAFOOF before this block, or --start TRAFOOF" : text;
}

AxisMapper::AxisMapper(const Machine* machine, const std::string& control) : machine_(machine), control_(control) {
  if (machine == nullptr) return;
  for (std::size_t i = 0; i < 3; ++i) linear_.at(i) = joint_called(*machine, kLinearNames.at(i)).value_or(0);
  at_zero_ = at_joints(Vec3::Zero(), {0, 0}, 0);
}

std::optional<std::size_t> AxisMapper::rotary_of(char letter) const {
  if (machine_ == nullptr) return std::nullopt;
  for (std::size_t k = 0; k < 2; ++k)
    if (machine_->joints[machine_->rotary.at(k)].name == std::string(1, letter)) return k;
  return std::nullopt;
}

AxisMap AxisMapper::at_joints(const Vec3& shift_mm, const RotaryAngles& angles, double length_mm) const {
  JointValues joints(machine_->joints.size(), 0.0);
  for (std::size_t k = 0; k < 2; ++k) joints[machine_->rotary.at(k)] = angles.at(k);
  for (int i = 0; i < 3; ++i) joints[linear_.at(static_cast<std::size_t>(i))] = shift_mm[i];
  const Pose zero = forward(*machine_, joints, length_mm);
  AxisMap map;
  map.axis = zero.axis.normalized();
  map.origin = zero.tip;
  for (int i = 0; i < 3; ++i) {
    double& value = joints[linear_.at(static_cast<std::size_t>(i))];
    value += 1;
    map.linear.col(i) = forward(*machine_, joints, length_mm).tip - zero.tip;
    value -= 1;
  }
  return map;
}

std::string AxisMapper::missing_point(const RotaryAngles& angles) const {
  for (std::size_t k = 0; k < 2; ++k) {
    const Joint& joint = machine_->joints[machine_->rotary.at(k)];
    if (joint.has_point || stands_at_zero(angles.at(k))) continue;
    return "the place of the tip needs a point on the axis of joint " + joint.name + "; expected --joint-point " +
           joint.name + "=X,Y,Z";
  }
  return {};
}

bool AxisMapper::needs_applied_length(const AxisFrame& state, const RotaryAngles& angles) const {
  if (state.plane) return true;
  if (machine_ == nullptr) return false;
  if (has_turned_tip_frame(state)) return true;
  for (std::size_t k = 0; k < 2; ++k) {
    const std::size_t joint = machine_->rotary.at(k);
    const bool turns_tool =
        machine_->joints[joint].side == JointSide::head || joint > linear_[2] || state.tip_control != TipControl::off;
    if (turns_tool && !stands_at_zero(angles.at(k))) return true;
  }
  return false;
}

AxisMap AxisMapper::map(const AxisFrame& state, const RotaryAngles& angles) const {
  AxisMap map;
  if (machine_ == nullptr) {
    map.origin = state.shift_mm + Vec3(0, 0, state.excess_length_mm);
  } else {
    AxisMap at_zero = at_zero_;
    at_zero.origin += at_zero.linear * state.shift_mm;
    const bool is_turned = !stands_at_zero(angles[0]) || !stands_at_zero(angles[1]);
    map = at_zero;
    if (!is_known(angles[0]) || !is_known(angles[1])) {
      if (!state.is_aligned) map.open = unknown_angles();
    } else if (is_turned && !state.is_aligned) {
      const Eigen::Matrix3d turn = tool_axes(*machine_, angles) * machine_->rest.rotation.transpose();
      map.axis = turn * at_zero.axis;
      if (state.tip_control == TipControl::unknown) map.open = unknown_tip_control();
      if (state.tip_control == TipControl::turned_offset) map.linear = turn * at_zero.linear;
      if (state.tip_control == TipControl::off) {
        // The length that the control applies runs along Z, and the tool along its axis.
        map = at_joints(state.shift_mm + Vec3(0, 0, state.tool_length_mm), angles, state.tool_length_mm);
        map.open = missing_point(angles);
      }
    }
    if (has_turned_tip_frame(state)) {
      const AxisMap at_call = at_joints(state.shift_mm, state.tip_frame, 0);
      map.linear = at_call.linear;
      map.origin = at_call.origin;
      if (map.open.empty()) map.open = missing_point(state.tip_frame);
      if (map.open.empty() && state.plane)
        map.open = "a tilted frame is in force, and the table turned before tool centre point control";
    }
    const Vec3 along = state.tip_control == TipControl::on ? map.axis : Vec3(map.linear.col(2));
    map.origin += state.excess_length_mm * along;
  }
  if (map.open.empty() && state.plane && std::abs(state.excess_length_mm) > 0)
    map.open = "the length that is applied in a tilted frame is not that of the tool";
  if (!state.open_length.empty()) {
    map.is_open_along_z =
        map.open.empty() && !state.plane && !state.frame &&
        (machine_ == nullptr || (state.tip_control == TipControl::off && !needs_true_length(*machine_)));
    map.open = state.open_length;
  }
  if (state.plane && !state.is_aligned) {
    map.open = "a tilted frame is in force, and the tool is not aligned with it";
    return map;
  }
  if (state.plane) {
    const Eigen::Matrix3d work = map.linear;
    map.origin = work * state.plane->shift + map.origin;
    map.linear = work * state.plane->rotation;
    map.axis = map.linear.col(2).normalized();
  }
  if (state.frame) {
    map.origin = map.tip(state.frame->shift);
    map.linear = map.linear * state.frame->linear;
  }
  return map;
}

}  // namespace gouge

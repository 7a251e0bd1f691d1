#include "cli/machine/joint_facts.h"

#include <algorithm>

#include "cli/values/parse_lengths.h"
#include "lib/base/number_text.h"
#include "lib/base/units.h"

namespace gouge {
namespace {

using Wrong = std::optional<std::string>;  // the expected text; none: the text is right

/// Returns a number of degrees in rad, or a length in mm.
std::optional<double> parse_value(const Joint& joint, const std::string& text) {
  if (joint.type == JointType::linear) return parse_length_mm(text);
  const std::optional<double> degrees = parse_number(text);
  return degrees ? std::optional(*degrees * kDegree_rad) : std::nullopt;
}

Wrong set_limit(const std::string& text, Joint& joint) {
  const bool is_rotary = joint.type == JointType::rotary;
  const std::string expected = is_rotary ? "LOW..HIGH in degrees, LOW.., ..HIGH, or free for a joint without limits"
                                         : "LOW..HIGH in mm or with a unit, LOW.. or ..HIGH";
  Joint changed = joint;
  changed.min = changed.max = std::nullopt;
  changed.is_continuous = is_rotary && text == "free";
  if (!changed.is_continuous) {
    const std::size_t dots = text.find("..");
    if (dots == std::string::npos) return expected;
    const std::string low = text.substr(0, dots), high = text.substr(dots + 2);
    if (!low.empty()) changed.min = parse_value(joint, low);
    if (!high.empty()) changed.max = parse_value(joint, high);
    const bool is_wrong = (!low.empty() && !changed.min) || (!high.empty() && !changed.max) ||
                          (!changed.min && !changed.max) || (changed.min && changed.max && *changed.min > *changed.max);
    if (is_wrong) return expected;
  }
  joint = changed;
  return std::nullopt;
}

Wrong set_point(const std::string& text, Joint& joint) {
  if (joint.type == JointType::linear) return "a rotary joint: a linear one has no point";
  const std::vector<std::string> parts = split_text(text, ',');
  const std::optional<RigidTransform> place = parts.size() == 3 ? parse_place(text) : std::nullopt;
  if (!place) return "X,Y,Z: lengths in mm, or with a unit (0.5in)";
  joint.point = place->shift;
  joint.point_slack_mm = 0;
  joint.has_point = true;
  return std::nullopt;
}

Wrong set_rate(const std::string& text, Joint& joint) {
  const std::optional<double> rate = parse_value(joint, text);
  if (!rate || !(*rate > 0))
    return joint.type == JointType::rotary ? "a rate above 0 in degrees per minute"
                                           : "a rate above 0 in mm per minute, or with a unit (40in)";
  joint.rate = rate;
  return std::nullopt;
}

std::string names_of(const Machine& machine) {
  std::string all;
  for (const Joint& joint : machine.joints) all += (all.empty() ? "" : ", ") + joint.name;
  return all;
}

/// Takes texts "JOINT=VALUE" of an option.
std::optional<Diagnostic> take(const std::vector<std::string>& typed, const std::string& option,
                               Wrong (*set)(const std::string&, Joint&), Machine& machine) {
  std::vector<std::string> taken;
  for (const std::string& text : typed) {
    const auto wrong = [&](const std::string& expected) {
      return make_error("usage", option + " '" + text + "': expected " + expected);
    };
    const std::size_t equals = text.find('=');
    const std::string name = text.substr(0, equals);
    const auto joint = std::ranges::find(machine.joints, name, &Joint::name);
    if (equals == std::string::npos || joint == machine.joints.end())
      return wrong("JOINT=VALUE with one of the joints " + names_of(machine) + " of machine " + machine.name);
    if (std::ranges::find(taken, name) != taken.end()) return wrong("each joint at most once");
    taken.push_back(name);
    if (const Wrong expected = set(text.substr(equals + 1), *joint)) return wrong(*expected);
  }
  return std::nullopt;
}

}  // namespace

std::optional<Diagnostic> state_joints(const StatedJoints& stated, const JointOptionNames& names, Machine& machine) {
  if (auto error = take(stated.limits, names.limit, &set_limit, machine)) return error;
  if (auto error = take(stated.points, names.point, &set_point, machine)) return error;
  return take(stated.rates, names.rate, &set_rate, machine);
}

std::vector<std::string> stated_texts(const StatedJoints& stated, const JointOptionNames& names) {
  std::vector<std::string> all;
  for (const std::string& text : stated.limits) all.push_back(names.limit + " " + text);
  for (const std::string& text : stated.points) all.push_back(names.point + " " + text);
  for (const std::string& text : stated.rates) all.push_back(names.rate + " " + text);
  return all;
}

}  // namespace gouge

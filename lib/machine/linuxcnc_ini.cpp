#include "lib/machine/linuxcnc_ini.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "lib/base/letters.h"
#include "lib/base/number_text.h"
#include "lib/base/units.h"

namespace gouge {
namespace {

constexpr double kSecondsPerMinute = 60;

struct Value {
  std::string text;
  std::size_t line = 0;
};

/// Adds the value of `setp PIN VALUE` as "setp/PIN"; the last of a pin counts, as in HAL.
void add_pin(std::map<std::string, Value>& values, std::string_view command, std::size_t line) {
  constexpr std::string_view kSet = "setp ";
  if (!command.starts_with(kSet)) return;
  const std::string_view rest = trim_blanks(command.substr(kSet.size()));
  const std::size_t space = rest.find_first_of(" \t");
  if (space == std::string_view::npos) return;
  values["setp/" + std::string(rest.substr(0, space))] = {std::string(trim_blanks(rest.substr(space))), line};
}

/// Returns whether a code is remapped to switch the kinematics, as in the configurations of LinuxCNC itself.
bool is_switch_of_kinematics(std::string_view remap) {
  constexpr std::array<std::string_view, 3> kCodes = {"M428", "M429", "M430"};
  const std::string code = in_capitals(remap.substr(0, remap.find_first_of(" \t")));
  return std::ranges::find(kCodes, std::string_view(code)) != kCodes.end();
}

/// The values of a configuration by "SECTION/KEY"; the first of a key counts. "SECTION/" stands for the section itself.
std::map<std::string, Value> values_of(std::string_view bytes) {
  std::map<std::string, Value> values;
  std::string section;
  for (std::size_t at = 0, number = 1; at < bytes.size(); ++number) {
    const std::size_t end = std::min(bytes.find('\n', at), bytes.size());
    const std::string_view line = trim_blanks(bytes.substr(at, end - at));
    at = end + 1;
    if (line.empty() || line.front() == '#' || line.front() == ';') continue;
    if (line.front() == '[') {
      section = line.substr(1, line.find(']') - 1);
      values.try_emplace(section + "/", Value{"", number});
      continue;
    }
    const std::size_t equals = line.find('=');
    if (equals == std::string_view::npos) continue;
    const std::string key = section + "/" + std::string(trim_blanks(line.substr(0, equals)));
    const std::string_view value = trim_blanks(line.substr(equals + 1));
    if (key == "HAL/HALCMD") add_pin(values, value, number);
    if (key == "RS274NGC/REMAP" && !is_switch_of_kinematics(value))
      values.try_emplace("RS274NGC/REMAP of another code", Value{std::string(value), number});
    values.try_emplace(key, Value{std::string(value), number});
  }
  return values;
}

/// A table that turns about C on a trunnion that turns about `letter`.
struct Kinematics {
  std::string_view name;
  char letter;
  Vec3 direction;
};
const std::array<Kinematics, 2>& known_kinematics() {
  static const std::array<Kinematics, 2> known = {Kinematics{"xyzac-trt-kins", 'A', Vec3::UnitX()},
                                                  {"xyzbc-trt-kins", 'B', Vec3::UnitY()}};
  return known;
}

std::string axis_section(const Joint& joint) { return "AXIS_" + joint.name; }

class IniReader {
 public:
  IniReader(const std::string& file, std::string_view bytes) : file_(file), values_(values_of(bytes)) {}

  Result<Machine> run() {
    const Kinematics* known = read_kinematics();
    read_units();
    const double sign = known != nullptr ? rotary_sign(std::string(known->name)) : 1;
    if (error_) return *error_;
    Machine machine;
    machine.name = "linuxcnc " + std::string(known->name);
    machine.source = file_ + "; LinuxCNC src/emc/kinematics/trtfuncs.c";
    machine.joints = {rotary('C', sign * Vec3::UnitZ()), rotary(known->letter, sign * known->direction),
                      linear('X', Vec3::UnitX()), linear('Y', Vec3::UnitY()), linear('Z', Vec3::UnitZ())};
    machine.control = {"LinuxCNC", TurnLaw::axis, TurnLaw::axis,
                       "LinuxCNC src/emc/tp/tc.c TC_LINEAR, with the kinematics switched on"};
    machine.control.program = "linuxcnc";
    machine.control.joint_rapid_law = TurnLaw::joint;
    if (const Value* start = find("RS274NGC/RS274NGC_STARTUP_CODE")) machine.control.start = start->text;
    machine.control.unread_setting = unread_setting();
    if (error_) return *error_;
    find_missing_axes(machine);
    Result<Machine> made = make_machine(std::move(machine));
    if (made) return made;
    return make_error(made.error().code, made.error().message, file_, 1);
  }

 private:
  const Value* find(const std::string& key) const {
    const auto value = values_.find(key);
    return value == values_.end() ? nullptr : &value->second;
  }

  /// Keeps the first error.
  void fail(const std::string& what, std::size_t line) {
    if (!error_) error_ = make_error("machine-ini", what, file_, line);
  }

  const Kinematics* read_kinematics() {
    const std::string expected = "expected xyzac-trt-kins or xyzbc-trt-kins, or write a machine file";
    const Value* stated = find("KINS/KINEMATICS");
    const std::string name = stated == nullptr ? "" : stated->text.substr(0, stated->text.find_first_of(" \t"));
    for (const Kinematics& one : known_kinematics())
      if (one.name == name) return &one;
    if (stated == nullptr)
      fail("[KINS] has no KINEMATICS; " + expected, 1);
    else
      fail("KINEMATICS is '" + name + "'; " + expected, stated->line);
    return nullptr;
  }

  /// Source: LinuxCNC, INI configuration, and the note in configs/sim/axis/vismach/5axis/table-rotary-tilting/xyzac-trt.ini.
  [[nodiscard]] std::string unread_setting() const {
    if (const Value* remap = find("RS274NGC/REMAP of another code")) return "REMAP = " + remap->text;
    for (const char letter : {'A', 'B', 'C'}) {
      const std::string key = std::string("AXIS_") + letter + "/WRAPPED_ROTARY";
      const Value* wrapped = find(key);
      if (wrapped != nullptr && wrapped->text != "0") return "[AXIS_" + std::string(1, letter) + "] WRAPPED_ROTARY";
    }
    const Value* kinematics = find("KINS/KINEMATICS");
    if (kinematics != nullptr && kinematics->text.find("sparm=identityfirst") == std::string::npos)
      return "KINEMATICS = " + kinematics->text + ", without sparm=identityfirst";
    return {};
  }

  void read_units() {
    if (const Value* angular = find("TRAJ/ANGULAR_UNITS");
        angular != nullptr && angular->text != "deg" && angular->text != "degree")
      fail("ANGULAR_UNITS is '" + angular->text + "'; expected deg", angular->line);
    const Value* unit = find("TRAJ/LINEAR_UNITS");
    const std::string text = unit == nullptr ? "" : unit->text;
    if (text == "inch" || text == "in" || text == "imperial")
      mm_per_unit_ = mm_per(LengthUnit::inch);
    else if (unit == nullptr)
      fail("[TRAJ] has no LINEAR_UNITS; expected mm or inch", 1);
    else if (text != "mm" && text != "metric")
      fail("LINEAR_UNITS is '" + text + "'; expected mm or inch", unit->line);
  }

  /// Returns 1 where rotations have the directions of ISO 841, else -1. A limit of a tilt has another side by each.
  double rotary_sign(const std::string& kinematics) {
    const std::string pin = kinematics + ".conventional-directions";
    const Value* value = find("setp/" + pin);
    if (value != nullptr && (value->text == "1" || value->text == "TRUE")) return 1;
    if (value != nullptr && (value->text == "0" || value->text == "FALSE")) return -1;
    if (value == nullptr)
      fail("no HALCMD states the rotary directions; add 'HALCMD = setp " + pin + " 0', or 1, to [HAL]", 1);
    else
      fail(pin + " is '" + value->text + "'; expected 0 or 1", value->line);
    return 0;
  }

  /// Returns the section of the joint that moves an axis. trtfuncs.c numbers the joints in the order of the letters in
  /// the parameter coordinates of the kinematics.
  [[nodiscard]] std::string joint_section(char letter) const {
    const std::string_view kinematics = find("KINS/KINEMATICS")->text;
    constexpr std::string_view kKey = "coordinates=";
    const std::size_t at = kinematics.find(kKey);
    std::string order = std::string("XYZ") + std::string(in_capitals(kinematics.substr(3, 2)));
    if (at != std::string_view::npos) {
      const std::string_view rest = kinematics.substr(at + kKey.size());
      order = in_capitals(rest.substr(0, rest.find_first_of(" \t")));
    }
    const std::size_t number = order.find(letter);
    return number == std::string::npos ? "" : "JOINT_" + std::to_string(number);
  }

  /// Returns the narrower one of the values of an axis and of its joint: LinuxCNC obeys both.
  std::optional<double> narrower(char letter, const char* key, bool is_minimum, double scale) {
    const std::optional<double> axis = number(std::string("AXIS_") + letter, key, scale);
    const std::optional<double> joint = number(joint_section(letter), key, scale);
    if (!axis || !joint) return axis ? axis : joint;
    return is_minimum ? std::max(*axis, *joint) : std::min(*axis, *joint);
  }

  std::optional<double> number(const std::string& section, const char* key, double scale) {
    const Value* value = find(section + "/" + key);
    if (value == nullptr) return std::nullopt;
    const std::optional<double> number = parse_number(value->text);
    if (number) return *number * scale;
    fail(std::string(key) + " is '" + value->text + "'; expected a number", value->line);
    return std::nullopt;
  }

  void find_missing_axes(Machine& machine) const {
    for (std::size_t k = 0; k < machine.joints.size(); ++k)
      if (find(axis_section(machine.joints[k]) + "/") == nullptr) machine.unread.push_back(k);
  }

  Joint joint(char letter, const Vec3& direction, double scale) {
    Joint made;
    made.name = std::string(1, letter);
    made.direction = direction;
    made.min = narrower(letter, "MIN_LIMIT", true, scale);
    made.max = narrower(letter, "MAX_LIMIT", false, scale);
    made.rate = narrower(letter, "MAX_VELOCITY", false, scale * kSecondsPerMinute);
    return made;
  }
  Joint linear(char letter, const Vec3& direction) { return joint(letter, direction, mm_per_unit_); }
  Joint rotary(char letter, const Vec3& direction) {
    Joint made = joint(letter, direction, kDegree_rad);
    made.type = JointType::rotary;
    made.side = JointSide::table;
    return made;
  }

  const std::string& file_;
  std::map<std::string, Value> values_;
  double mm_per_unit_ = 1;
  std::optional<Diagnostic> error_;
};

}  // namespace

bool is_linuxcnc_ini(std::string_view bytes) {
  return bytes.starts_with("[KINS]") || bytes.find("\n[KINS]") != std::string_view::npos;
}

Diagnostics describe_missing_axes(const Machine& machine, const std::string& file) {
  std::string missing;
  for (const std::size_t k : machine.unread) {
    const Joint& joint = machine.joints[k];
    if (joint.is_continuous || joint.min || joint.max) continue;
    missing += (missing.empty() ? "[" : ", [") + axis_section(joint) + "]";
  }
  if (missing.empty()) return {};
  return {make_warning("machine-no-limits",
                       "there is no section " + missing +
                           ", so limits are not known and not checked; add MIN_LIMIT, MAX_LIMIT and MAX_VELOCITY there",
                       file)};
}

Result<Machine> read_linuxcnc_ini(const std::string& file, std::string_view bytes) {
  return IniReader(file, bytes).run();
}

}  // namespace gouge

#include "lib/machine/read_machine.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "lib/base/number_text.h"
#include "lib/base/tolerance.h"
#include "lib/base/units.h"
#include "lib/json/json_field.h"
#include "lib/json/json_file.h"

namespace gouge {
namespace {

/// Returns whether a name fits into options, messages and the heading of a CSV file.
bool is_joint_name(const std::string& name) {
  const auto is_plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-' ||
           c == '.' || c == ' ';
  };
  const bool is_column = name == "move" || name == "line" || name == "kind";  // of `path joints --csv`
  return !name.empty() && !is_column && std::ranges::all_of(name, is_plain);
}

const std::vector<std::string> kRapidLaws(kTurnLawNames.begin(), kTurnLawNames.end()),
    kFeedLawWords(kTurnLawNames.begin(), kTurnLawNames.begin() + kFeedLaws);

// Laws of rapids without tool centre point control.
const std::vector<std::string> kJointLaws = {"joint", "independent"};

struct Interval {
  double middle = 0, half = 0;
};

class MachineReader {
 public:
  MachineReader(const JsonField& root, const nlohmann::json& value) : root_(root), value_(value) {}

  Machine run() {
    allow(value_, root_, {"name", "unit", "source", "joints", "control"});
    Machine machine;
    machine.name = root_.at("name").text();
    if (machine.name.empty()) root_.at("name").fail("the name of the machine");
    if (const auto source = root_.find("source")) machine.source = source->text();
    if (const auto unit = root_.find("unit"); unit && unit->word({"mm", "inch"}) == 1)
      mm_per_unit_ = mm_per(LengthUnit::inch);
    const std::vector<JsonField> joints = root_.at("joints").list();
    for (std::size_t k = 0; k < joints.size(); ++k) machine.joints.push_back(joint(joints[k], value_["joints"][k]));
    refuse_same_names(machine, joints);
    if (const auto field = root_.find("control")) machine.control = control(*field, value_["control"]);
    return machine;
  }

 private:
  static void allow(const nlohmann::json& value, const JsonField& field, const std::vector<std::string>& keys) {
    if (!value.is_object()) return;
    for (const auto& [key, rest] : value.items()) {
      if (std::ranges::find(keys, key) != keys.end()) continue;
      std::string all;
      for (const std::string& known : keys) all += (all.empty() ? "" : ", ") + known;
      field.at(key).fail("one of the keys " + all);
    }
  }

  static void refuse_same_names(const Machine& machine, const std::vector<JsonField>& fields) {
    for (std::size_t k = 0; k < fields.size(); ++k) {
      const auto before = machine.joints.begin() + static_cast<std::ptrdiff_t>(k);
      if (std::find_if(machine.joints.begin(), before, [&](const Joint& one) { return one.name == before->name; }) !=
          before)
        fields[k].at("name").fail("a name that no joint before it has");
    }
  }

  static Vec3 vector(const JsonField& field) {
    const std::vector<JsonField> numbers = field.list();
    if (numbers.size() != 3) {
      field.fail("three numbers");
      return Vec3::Zero();
    }
    return {numbers[0].number(), numbers[1].number(), numbers[2].number()};
  }

  [[nodiscard]] static std::optional<double> scaled(const JsonField& from, const char* key, double scale) {
    const std::optional<JsonField> field = from.find(key);
    if (!field || field->is_null()) return std::nullopt;
    return field->number() * scale;
  }

  /// Reads a coordinate that is a number, or a pair [low, high].
  static Interval interval(const JsonField& field) {
    if (!field.is_list()) {
      const double value = field.number();
      return {value, 0};
    }
    const std::vector<JsonField> ends = field.list();
    if (ends.size() != 2) {
      field.fail("a number, or a pair [low, high]");
      return {};
    }
    const double low = ends[0].number(), high = ends[1].number();
    if (!(low <= high)) field.fail("a pair [low, high] with low <= high");
    return {0.5 * (low + high), 0.5 * (high - low)};
  }

  /// Takes the middle of the intervals, and the farthest that a point of them is from the axis through the middle.
  void read_point(const JsonField& field, Joint& joint) const {
    const std::vector<JsonField> coordinates = field.list();
    if (coordinates.size() != 3) return field.fail("three coordinates, each a number or a pair [low, high]");
    Vec3 half = Vec3::Zero();
    for (int k = 0; k < 3; ++k) {
      const Interval one = interval(coordinates[static_cast<std::size_t>(k)]);
      joint.point[k] = one.middle * mm_per_unit_;
      half[k] = one.half * mm_per_unit_;
    }
    joint.has_point = true;
    if (!(joint.direction.norm() > Tolerance::kNoDirection)) return;
    const Vec3 d = joint.direction.normalized();
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3 off = half.cwiseProduct(Vec3(corner % 2 * 2 - 1, corner / 2 % 2 * 2 - 1, corner / 4 * 2 - 1));
      joint.point_slack_mm = std::max(joint.point_slack_mm, d.cross(off).norm());
    }
  }

  [[nodiscard]] static double preference(const JsonField& from) {
    const std::optional<double> sign = scaled(from, "preference", 1);
    if (sign && std::abs(std::abs(*sign) - 1) > 0) from.at("preference").fail("1 or -1");
    return sign.value_or(0);
  }

  [[nodiscard]] Joint joint(const JsonField& field, const nlohmann::json& value) const {
    allow(value, field,
          {"name", "type", "side", "direction", "point", "min", "max", "continuous", "rate", "preference"});
    Joint joint;
    joint.name = field.at("name").text();
    if (!is_joint_name(joint.name))
      field.at("name").fail("a name such as X or C1: letters, digits, '_', '-', '.' and blanks");
    joint.type = field.at("type").word({"linear", "rotary"}) == 1 ? JointType::rotary : JointType::linear;
    joint.side = field.at("side").word({"table", "head"}) == 1 ? JointSide::head : JointSide::table;
    joint.direction = vector(field.at("direction"));
    if (const auto point = field.find("point"); point && !point->is_null()) {
      read_point(*point, joint);
    }
    const double scale = joint.type == JointType::rotary ? kDegree_rad : mm_per_unit_;
    joint.min = scaled(field, "min", scale);
    joint.max = scaled(field, "max", scale);
    joint.rate = scaled(field, "rate", scale);
    joint.preference = preference(field);
    if (const auto endless = field.find("continuous")) joint.is_continuous = endless->flag();
    return joint;
  }

  static std::optional<TurnLaw> law(const JsonField& from, const char* key, const std::vector<std::string>& words) {
    const std::optional<JsonField> field = from.find(key);
    if (!field || field->is_null()) return std::nullopt;
    return static_cast<TurnLaw>(field->word(words));
  }

  /// Reads a tolerance of at least 0 and at most `max` in the unit of the file.
  [[nodiscard]] static double tolerance(const JsonField& from, const char* key, double scale, double max) {
    const std::optional<double> value = scaled(from, key, 1);
    if (value && !(*value >= 0 && *value <= max)) from.at(key).fail("a number from 0 to " + exact_text(max));
    return value.value_or(0) * scale;
  }

  [[nodiscard]] Control control(const JsonField& field, const nlohmann::json& value) const {
    constexpr double kMaxTip = 100, kMaxAxis_deg = 10;
    allow(value, field,
          {"name", "feed_law", "rapid_law", "joint_rapid_law", "program", "start", "source", "tip_tolerance",
           "axis_tolerance"});
    Control control;
    control.name = field.at("name").text();
    control.feed_law = law(field, "feed_law", kFeedLawWords);
    control.rapid_law = law(field, "rapid_law", kRapidLaws);
    if (const auto joints = field.find("joint_rapid_law"); joints && !joints->is_null())
      control.joint_rapid_law = joints->word(kJointLaws) == 0 ? TurnLaw::joint : TurnLaw::independent;
    if (const auto program = field.find("program"))
      control.program = kProgramLanguages.at(program->word(kProgramLanguages));
    if (const auto start = field.find("start")) control.start = start->text();
    if (const auto source = field.find("source")) control.source = source->text();
    control.tip_tolerance_mm = tolerance(field, "tip_tolerance", mm_per_unit_, kMaxTip);
    control.axis_tolerance_rad = tolerance(field, "axis_tolerance", kDegree_rad, kMaxAxis_deg);
    return control;
  }

  JsonField root_;
  const nlohmann::json& value_;
  double mm_per_unit_ = 1;
};

}  // namespace

Result<Machine> read_machine(const std::string& file, std::string_view bytes) {
  const Result<JsonFile> json = parse_json(file, bytes, {"machine-syntax", "machine-duplicate-key", "a machine file"});
  if (!json) return json.error();
  if (!json->root.is_object())
    return make_error("machine-syntax", "this is not an object; expected {\"name\": ..., \"joints\": [...]}", file, 1);
  JsonErrors errors{file, "machine-field", &json->lines};
  Machine read = MachineReader(JsonField(json->root, errors), json->root).run();
  if (errors.first) return *errors.first;
  Result<Machine> machine = make_machine(std::move(read));
  if (!machine) return make_error(machine.error().code, machine.error().message, file, json->lines.at("/joints"));
  return machine;
}

const MachinePreset* find_preset(std::string_view name) {
  const std::vector<MachinePreset>& all = machine_presets();
  const auto found = std::ranges::find(all, name, &MachinePreset::name);
  return found == all.end() ? nullptr : &*found;
}

}  // namespace gouge

#include "lib/machine/draw_machine.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "lib/base/number_text.h"
#include "lib/base/units.h"
#include "lib/machine/iso_view.h"

namespace gouge {
namespace {

constexpr double kWidth = 1500, kHeight = 1000;
constexpr double kPanel = 960;                           // left end of the list of joints
constexpr double kHeadMiddle = 330, kTableMiddle = 750;  // heights of gauge point and part zero
constexpr double kSceneMiddle = 560, kTriad = 210;       // horizontal places of the scenes and of linear joints
constexpr double kUpright = 0.1;  // an axis that points down by more than this is shown by its upper end
constexpr double kReach = 110;    // picture units for the farthest point of an axis
constexpr Colour kInk{32, 38, 46, 1}, kSoft{104, 112, 122, 1}, kHair{206, 211, 217, 1};
constexpr Colour kMetal{222, 226, 231, 1}, kPart{190, 205, 224, 1}, kTool{236, 200, 120, 1};
constexpr std::array<Colour, 3> kLinear = {Colour{178, 24, 43, 1}, {34, 120, 84, 1}, {33, 102, 172, 1}};
constexpr std::array<Colour, 2> kRotary = {Colour{191, 87, 0, 1}, {118, 42, 131, 1}};

std::string number(double value) { return display_text(value, 3); }

std::string vector_text(const Vec3& v) {
  return "(" + number(v.x()) + ", " + number(v.y()) + ", " + number(v.z()) + ")";
}

double shown(const Joint& joint, double value) { return is_rotary(joint) ? value / kDegree_rad : value; }
const char* unit_of(const Joint& joint) { return is_rotary(joint) ? " deg" : " mm"; }

std::string limits_text(const Joint& joint) {
  if (joint.is_continuous) return "turns without end";
  if (!joint.min && !joint.max) return "limits not known";
  const auto bound = [&](const std::optional<double>& value) { return number(shown(joint, *value)); };
  if (!joint.max) return "from " + bound(joint.min) + unit_of(joint);
  if (!joint.min) return "up to " + bound(joint.max) + unit_of(joint);
  return bound(joint.min) + " to " + bound(joint.max) + unit_of(joint);
}

/// Breaks a text at blanks into lines of at most `columns` letters, and at most `most` lines.
std::vector<std::string> broken(const std::string& text, std::size_t columns, std::size_t most) {
  std::vector<std::string> lines = {""};
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    const std::string word = text.substr(at, end - at);
    if (!lines.back().empty() && lines.back().size() + 1 + word.size() > columns) {
      if (lines.size() == most) {
        lines.back() += " ...";
        return lines;
      }
      lines.emplace_back();
    }
    lines.back() += (lines.back().empty() ? "" : " ") + word;
    at = end + 1;
  }
  return lines;
}

class Sheet {
 public:
  explicit Sheet(const Machine& machine) : machine_(machine) {
    std::size_t linear = 0, rotary = 0;
    for (const Joint& joint : machine.joints)
      colours_.push_back(is_rotary(joint) ? kRotary[rotary++ % kRotary.size()] : kLinear[linear++ % kLinear.size()]);
  }

  Drawing draw() {
    drawing_.width = kWidth;
    drawing_.height = kHeight;
    draw_title();
    draw_head_side();
    draw_table_side();
    draw_list();
    draw_legend();
    return std::move(drawing_);
  }

 private:
  void write(const Vec2& at, const std::string& text, double size, const Colour& colour = kInk, bool is_bold = false) {
    drawing_.items.emplace_back(DrawnText{at, text, size, colour, TextAnchor::left, is_bold});
  }
  void rule(const Vec2& from, const Vec2& to, double width = 1) {
    drawing_.items.emplace_back(DrawnLine{{from, to}, kHair, width, false, {}});
  }

  void draw_title() {
    write({40, 50}, machine_.name, 28, kInk, true);
    double y = 76;
    for (const std::string& line :
         broken("Source: " + (machine_.source.empty() ? "not given" : machine_.source), 190, 2)) {
      write({40, y}, line, 14, kSoft);
      y += 18;
    }
    rule({40, 106}, {kWidth - 40, 106});
    rule({40, 540}, {kPanel - 60, 540});
    rule({kPanel - 30, 126}, {kPanel - 30, kHeight - 40});
  }

  /// Returns the picture units for 1 mm of a side: its farthest axis is kReach away from the zero.
  [[nodiscard]] double scale_of(JointSide side) const {
    double farthest = 0;
    for (const Joint& joint : machine_.joints)
      if (is_rotary(joint) && joint.side == side && joint.has_point)
        farthest = std::max(farthest, across(joint).norm());
    return farthest > 0 ? kReach / farthest : 1;
  }

  /// Returns the point of a rotary axis that is nearest to the zero of its side.
  [[nodiscard]] static Vec3 across(const Joint& joint) {
    return joint.point - joint.direction.dot(joint.point) * joint.direction;
  }

  void draw_head_side() {
    write({40, 134}, "Head side: moves the tool", 17, kInk, true);
    IsoView view(drawing_, Vec2(kSceneMiddle, kHeadMiddle));
    constexpr double kTip = -80, kNose = 24, kSpindle = 92;
    view.cylinder(Vec3(0, 0, kTip), -kTip, 8, kTool, kSoft);
    view.cylinder(Vec3(0, 0, 0), kNose, 20, kMetal, kSoft);
    view.cylinder(Vec3(0, 0, kNose), kSpindle, 40, kMetal, kSoft);
    draw_rotary_axes(view, JointSide::head);
    view.dot(Vec3(0, 0, kTip), 5, kInk, true);
    view.text(view.at(Vec3(0, 0, kTip)) + Vec2(14, 10), "tool tip", 14, kInk);
    label_zero(view, Vec2(-54, 26), "gauge point");
    draw_linear_joints(JointSide::head, kHeadMiddle + 20);
  }

  void draw_table_side() {
    write({40, 572}, "Table side: moves the part", 17, kInk, true);
    IsoView view(drawing_, Vec2(kSceneMiddle, kTableMiddle));
    constexpr double kBlock = 40, kPlate = 16, kRadius = 130;
    const bool is_round = std::ranges::any_of(
        machine_.joints, [](const Joint& joint) { return is_rotary(joint) && joint.side == JointSide::table; });
    if (is_round)
      view.cylinder(Vec3(0, 0, -kBlock - kPlate), kPlate, kRadius, kMetal, kSoft);
    else
      view.box(Vec3(-kRadius, -kRadius, -kBlock - kPlate), Vec3(kRadius, kRadius, -kBlock), kMetal, kSoft);
    view.box(Vec3(-48, -36, -kBlock), Vec3(48, 36, 0), kPart, kSoft);
    draw_rotary_axes(view, JointSide::table);
    draw_part_zero(view);
    draw_linear_joints(JointSide::table, kTableMiddle + 40);
  }

  /// Marks the zero of a side, with a name to the left at `by`.
  void label_zero(IsoView& view, const Vec2& by, const std::string& name) {
    const Vec2 zero = view.at(Vec3::Zero());
    drawing_.items.emplace_back(DrawnLine{{zero, zero + by}, kInk, 1, false, {}});
    view.zero_mark(Vec3::Zero(), 8, kInk);
    view.text(zero + by + Vec2(-5, 5), name, 14, kInk, TextAnchor::right);
  }

  void draw_part_zero(IsoView& view) {
    constexpr double kAxis = 44;
    const std::array<const char*, 3> names = {"x", "y", "z"};
    for (int k = 0; k < 3; ++k) {
      const Vec3 end = kAxis * Vec3::Unit(k);
      view.arrow(Vec3::Zero(), end, kInk, 1.5);
      const Vec2 way = (view.at(end) - view.at(Vec3::Zero())).normalized();
      view.text(view.at(end) + 11 * way + Vec2(-4, 5), names[static_cast<std::size_t>(k)], 14, kInk);
    }
    label_zero(view, Vec2(-118, 128), "part zero");
  }

  void draw_rotary_axes(IsoView& view, JointSide side) {
    constexpr double kBack = 150, kFront = 172, kTurn = 30, kUnknown = 104;
    const double scale = scale_of(side);
    struct Label {
      Vec3 from, to;
      std::size_t joint;
    };
    std::vector<Label> labels;
    for (std::size_t k = 0; k < machine_.joints.size(); ++k) {
      const Joint& joint = machine_.joints[k];
      if (!is_rotary(joint) || joint.side != side) continue;
      const Colour& colour = colours_[k];
      const Vec3 middle = joint.has_point ? Vec3(scale * across(joint)) : Vec3(Vec3::Zero());
      const Vec3 upper = joint.direction.z() < -kUpright ? Vec3(-joint.direction) : joint.direction;
      const Vec3 end = middle + kFront * upper;
      view.line(middle - kBack * upper, end, colour, 2, {16, 5, 3, 5});
      view.turn_arrow(end - 24 * upper, joint.direction, kTurn, colour, 3);
      if (joint.has_point) view.line(Vec3::Zero(), middle, kSoft, 1, {3, 3});
      view.dot(joint.has_point ? middle : Vec3(middle - kUnknown * upper), 6, colour, joint.has_point);
      labels.push_back({middle, end, k});
    }
    for (const Label& label : labels) {
      const Joint& joint = machine_.joints[label.joint];
      view.end_label(label.from, label.to, {joint.name, limits_text(joint)}, colours_[label.joint]);
    }
  }

  void draw_linear_joints(JointSide side, double y) {
    constexpr double kArrow = 84;
    IsoView view(drawing_, Vec2(kTriad, y));
    bool has_joints = false;
    for (std::size_t k = 0; k < machine_.joints.size(); ++k) {
      const Joint& joint = machine_.joints[k];
      if (is_rotary(joint) || joint.side != side) continue;
      has_joints = true;
      const Vec3 end = kArrow * joint.direction;
      view.arrow(Vec3::Zero(), end, colours_[k], 3.5);
      view.end_label(Vec3::Zero(), end, {joint.name, limits_text(joint)}, colours_[k]);
    }
    if (has_joints) view.dot(Vec3::Zero(), 4, kInk, true);
    if (std::ranges::none_of(machine_.joints, [&](const Joint& joint) { return joint.side == side; }))
      write({40, y - 170}, "no joints: it stands", 14, kSoft);
  }

  /// Draws the joints from the tool to the part, and the laws.
  void draw_list() {
    constexpr double kStep = 76, kTop = 186;
    write({kPanel, 134}, "Chain from the tool to the part", 17, kInk, true);
    const double x = kPanel + 9, end = kTop + kStep * static_cast<double>(machine_.joints.size()) - 14;
    rule({x, 160}, {x, end + 2}, 2);
    write({kPanel + 30, 166}, "tool", 14, kSoft);
    double y = kTop;
    for (std::size_t k = machine_.joints.size(); k-- > 0; y += kStep) draw_entry(machine_.joints[k], colours_[k], y);
    write({kPanel + 30, end + 12}, "part", 14, kSoft);
    draw_laws(end + 54);
  }

  void draw_entry(const Joint& joint, const Colour& colour, double y) {
    IsoView(drawing_, Vec2(kPanel + 9, y + 8)).dot(Vec3::Zero(), 8, colour, true);
    write({kPanel + 30, y + 14}, joint.name, 19, colour, true);
    const double name = 16 + 13 * static_cast<double>(joint.name.size());
    write({kPanel + 30 + name, y + 14},
          std::string(is_rotary(joint) ? "rotary, " : "linear, ") +
              (joint.side == JointSide::table ? "table" : "head") + (is_rotary(joint) ? ", about " : ", along ") +
              vector_text(joint.direction),
          14);
    std::string facts = limits_text(joint);
    if (joint.rate) facts += ", " + number(shown(joint, *joint.rate)) + unit_of(joint) + "/min";
    write({kPanel + 30, y + 33}, facts, 14, kSoft);
    if (is_rotary(joint))
      write({kPanel + 30, y + 51},
            joint.has_point ? "axis through " + vector_text(joint.point) + " mm" : "place of the axis not known", 14,
            kSoft);
  }

  void draw_laws(double y) {
    const Control& control = machine_.control;
    const auto name = [](const std::optional<TurnLaw>& law) { return law ? turn_law_name(*law) : "not given"; };
    write({kPanel, y}, "Control: " + (control.name.empty() ? "not given" : control.name), 17, kInk, true);
    y += 24;
    write({kPanel, y},
          "law of feeds: " + std::string(name(control.feed_law)) + ", law of rapids: " + name(control.rapid_law), 14);
    for (const std::string& line : broken(control.source, 74, 3)) write({kPanel, y += 19}, line, 14, kSoft);
  }

  void draw_legend() {
    constexpr double kTop = 838, kStep = 25, kText = kPanel + 56;
    write({kPanel, kTop - 18}, "Legend", 17, kInk, true);
    const auto view = [&](int row) { return IsoView(drawing_, Vec2(kPanel + 20, kTop + 8 + kStep * row)); };
    const Vec3 left = Vec3(-1, -1, 0) * 12;
    view(0).arrow(left, -left, kInk, 3);
    write({kText, kTop + 13}, "positive motion of the tool relative to the part, as in ISO 841", 14);
    view(1).line(left, -left, kInk, 2, {9, 3, 2, 3});
    write({kText, kTop + 13 + kStep}, "axis of a rotary joint, with all joints at 0", 14);
    view(2).dot(0.6 * left, 6, kInk, true);
    view(2).dot(-0.6 * left, 6, kInk, false);
    write({kText, kTop + 13 + 2 * kStep}, "place of a rotary axis: known, not known", 14);
    view(3).zero_mark(Vec3::Zero(), 8, kInk);
    write({kText, kTop + 13 + 3 * kStep}, "part zero; gauge point, from which the tool length counts", 14);
    write({kPanel, kTop + 13 + 4 * kStep}, "Distances of axes are to scale within each side, other shapes are not.", 14,
          kSoft);
  }

  const Machine& machine_;
  std::vector<Colour> colours_;  // of each joint
  Drawing drawing_;
};

}  // namespace

Drawing draw_machine(const Machine& machine) { return Sheet(machine).draw(); }

}  // namespace gouge

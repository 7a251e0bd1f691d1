#pragma once

#include <array>
#include <numbers>
#include <optional>
#include <string>

#include "lib/base/number_text.h"
#include "lib/base/units.h"
#include "lib/machine/joint_path.h"
#include "lib/path/toolpath.h"

// Writes a path as a plain program with tool centre point control, for tests of the readers. Header only.

namespace gouge::test {

/// Controls that the writer knows.
enum class WrittenControl { linuxcnc, haas, fanuc };

/// Words in which the controls differ.
struct WrittenWords {
  std::string_view begin, tip_control, end;  ///< `tip_control`: before the number of the tool, if it ends with H
  bool needs_points = false;                 ///< 10 is written as 10.
  bool has_several_turns = false;            ///< P of an arc
};

inline const WrittenWords& words_of(WrittenControl control) {
  static const std::array<WrittenWords, 3> kWords = {{
      {"G90 G91.1 G17 G94 G61 ", "M428\n", "M2\n", false, true},
      {"%\nO1000\nG90 G17 G94 G40 G49 G80 G54 ", "G234 H", "M30\n%\n", true, false},
      {"%\nO1000\nG90 G17 G94 G40 G49 G80 G54 ", "G43.4 H", "M30\n%\n", true, false},
  }};
  return kWords.at(static_cast<std::size_t>(control));
}

/// Returns the program; nothing: a move has no angles, or an arc that the writer does not state.
inline std::optional<std::string> write_program(const Toolpath& path, const Machine& machine,
                                                WrittenControl control = WrittenControl::linuxcnc) {
  const WrittenWords& words = words_of(control);
  const JointChoice choice = choose_joints(machine, path);
  const double unit = mm_per(path.unit);
  std::string text(words.begin);
  text += std::string(path.unit == LengthUnit::inch ? "G20" : "G21") + "\n";
  std::size_t tool = kNone;
  const auto word = [&](char letter, double value) {
    std::string number = exact_text(value);
    if (words.needs_points && number.find('.') == std::string::npos) number += '.';
    return " " + std::string(1, letter) + number;
  };
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const Move& move = path.moves[i];
    if (!choice.path.end[i]) return std::nullopt;
    const bool changes_tool = move.tool != tool && move.tool != kNone && path.tools[move.tool].number;
    if (changes_tool) text += "T" + std::to_string(*path.tools[move.tool].number) + " M6\n";
    tool = move.tool;
    if (i == 0 || changes_tool) {
      text += words.tip_control;
      if (words.tip_control.ends_with('H')) text += std::to_string(path.tools.at(tool).number.value_or(1)) + "\n";
    }
    std::string block = move.kind == MoveKind::rapid || !move.has_start ? "G0" : "G1";
    std::string centre;
    if (move.curve_kind == CurveKind::spline) return std::nullopt;
    if (move.curve_kind == CurveKind::arc) {
      const PathArc& arc = path.arcs[move.curve];
      if (std::abs(std::abs(arc.axis.z()) - 1) > 0) return std::nullopt;
      block = arc.axis.z() * arc.sweep_rad > 0 ? "G3" : "G2";
      const Vec3 to = (arc.center - path.start_of(i).tip) / unit;
      centre = word('I', to.x()) + word('J', to.y());
      const int turns = static_cast<int>(std::abs(arc.sweep_rad) / (2 * std::numbers::pi) - 1e-9);
      if (turns > 0 && !words.has_several_turns) return std::nullopt;
      if (turns > 0) centre += word('P', turns + 1);
    }
    for (int k = 0; k < 3; ++k) block += word("XYZ"[k], move.end.tip[k] / unit);
    for (std::size_t k = 0; k < 2; ++k)
      block += word(machine.joints[machine.rotary[k]].name[0], (*choice.path.end[i])[k] / kDegree_rad);
    text += block + centre + (block[1] == '0' ? "" : word('F', 100)) + "\n";
  }
  return text + std::string(words.end);
}

}  // namespace gouge::test

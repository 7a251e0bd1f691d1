#pragma once

#include <numbers>
#include <optional>
#include <string>

#include "lib/base/number_text.h"
#include "lib/base/units.h"
#include "lib/machine/joint_path.h"
#include "lib/path/toolpath.h"

// Writes a path as a plain program of LinuxCNC with tool centre point control, for tests of its reader. Header only.

namespace gouge::test {

/// Returns the program; nothing: a move has no angles, or an arc is not about the axis Z.
inline std::optional<std::string> write_program(const Toolpath& path, const Machine& machine) {
  const JointChoice choice = choose_joints(machine, path);
  const double unit = mm_per(path.unit);
  std::string text = std::string(path.unit == LengthUnit::inch ? "G20" : "G21") + " G90 G91.1 G17 G94 G61\nM428\n";
  std::size_t tool = kNone;
  const auto word = [&](char letter, double value) { return " " + std::string(1, letter) + exact_text(value); };
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const Move& move = path.moves[i];
    if (!choice.path.end[i]) return std::nullopt;
    if (move.tool != tool && move.tool != kNone && path.tools[move.tool].number)
      text += "T" + std::to_string(*path.tools[move.tool].number) + " M6\n";
    tool = move.tool;
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
      if (turns > 0) centre += word('P', turns + 1);
    }
    for (int k = 0; k < 3; ++k) block += word("XYZ"[k], move.end.tip[k] / unit);
    for (std::size_t k = 0; k < 2; ++k)
      block += word(machine.joints[machine.rotary[k]].name[0], (*choice.path.end[i])[k] / kDegree_rad);
    text += block + centre + (block[1] == '0' ? "" : " F100") + "\n";
  }
  return text + "M2\n";
}

}  // namespace gouge::test

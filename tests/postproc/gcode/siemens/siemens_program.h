#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "lib/machine/read_machine.h"
#include "postproc/gcode/reading/read_gcode.h"

// Programs of Siemens controls as text, and what is read of them.

namespace gouge::test {

/// A C table on a B trunnion whose axes meet in (0, 0, -50).
inline std::shared_ptr<const Machine> table_machine() {
  Result<Machine> machine = read_machine("table", R"({"name": "table", "joints": [
    {"name": "C", "type": "rotary", "side": "table", "direction": [0, 0, 1], "point": [0, 0, -50], "continuous": true},
    {"name": "B", "type": "rotary", "side": "table", "direction": [0, 1, 0], "point": [0, 0, -50], "min": -110, "max": 110},
    {"name": "X", "type": "linear", "side": "head", "direction": [1, 0, 0]},
    {"name": "Y", "type": "linear", "side": "head", "direction": [0, 1, 0]},
    {"name": "Z", "type": "linear", "side": "head", "direction": [0, 0, 1]}]})");
  return machine ? std::make_shared<const Machine>(std::move(*machine)) : nullptr;
}

/// Set-up with everything that the program does not state, and the machine.
inline ProgramSetup full_setup() {
  ProgramSetup setup;
  setup.machine = table_machine();
  setup.offsets["G54"] = WorkOffset{};
  setup.tool_length_mm = 100;
  setup.are_joint_rapids_straight = true;
  return setup;
}

inline ReadOutcome read_siemens(const std::string& text, ProgramSetup setup = {},
                                std::vector<std::string> harmless = {}) {
  setup.control = "siemens";
  return read_gcode("program.mpf", SourceText(text), {std::move(setup), std::nullopt, std::move(harmless), ""}, {});
}

/// States in force at the start of most programs here, a tool, and a first place.
inline const std::string kHead = "G17 G71 G90 G94 G60 G54\nTRAFOOF\nT=\"MILL 8\" M6\nG0 X0 Y0 Z50 D1\n";
inline constexpr std::size_t kHeadMoves = 1;

/// Returns the path of a program that can be read.
inline Toolpath path_of_siemens(const std::string& text, ProgramSetup setup = {}) {
  ReadOutcome outcome = read_siemens(text, std::move(setup));
  if (!outcome.toolpath) {
    ADD_FAILURE() << text << "\n" << (outcome.errors.empty() ? "no path" : to_text(outcome.errors.front()));
    return {};
  }
  return std::move(*outcome.toolpath);
}

/// Returns whether a verdict on the path can be clean: every move is checked, and no fact is unknown.
inline bool can_be_clean(const ReadOutcome& outcome) {
  if (!outcome.toolpath || !outcome.toolpath->words_not_understood.empty()) return false;
  for (const Move& move : outcome.toolpath->moves)
    if (!move.not_checked_reason.empty()) return false;
  for (const Assumption& fact : outcome.toolpath->assumptions)
    if (fact.basis == Basis::unknown || fact.basis == Basis::contradicted) return false;
  return true;
}

/// Returns the reasons of all moves that are not checked, and all notes, with line ends between them.
inline std::string reasons_of(const ReadOutcome& outcome) {
  std::string all;
  if (!outcome.toolpath) return outcome.errors.empty() ? all : to_text(outcome.errors.front());
  for (const Move& move : outcome.toolpath->moves)
    if (!move.not_checked_reason.empty())
      all += std::to_string(move.line) + ": " + std::string(move.not_checked_reason) + "\n";
  for (const Diagnostic& note : outcome.toolpath->notes) all += note.message + "\n";
  return all;
}

/// Returns the tip at the end of the last move of blocks that follow the head; they must all be checked.
inline Vec3 tip_after(const std::string& blocks, ProgramSetup setup = {}) {
  setup.are_joint_rapids_straight = true;
  const ReadOutcome outcome = read_siemens(kHead + blocks + "M30\n", std::move(setup));
  EXPECT_TRUE(can_be_clean(outcome)) << blocks << reasons_of(outcome);
  if (!outcome.toolpath || outcome.toolpath->moves.empty()) return Vec3::Constant(AxisPlace::kUnknownCoordinate);
  return outcome.toolpath->moves.back().end.tip;
}

inline void expect_at(const Vec3& tip, double x, double y, double z, double within = 1e-9) {
  EXPECT_NEAR((tip - Vec3(x, y, z)).norm(), 0, within) << tip.transpose();
}

}  // namespace gouge::test

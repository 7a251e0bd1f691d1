#pragma once

#include <memory>
#include <string>

#include "tests/postproc/gcode/program.h"

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
  return path_in(read_siemens(text, std::move(setup)), text);
}

/// Returns the tip at the end of the last move of blocks that follow the head; they must all be checked.
inline Vec3 tip_after(const std::string& blocks, ProgramSetup setup = {}) {
  setup.are_joint_rapids_straight = true;
  const ReadOutcome outcome = read_siemens(kHead + blocks + "M30\n", std::move(setup));
  EXPECT_TRUE(can_be_clean(outcome)) << blocks << reasons_of(outcome);
  if (!outcome.toolpath || outcome.toolpath->moves.empty()) return Vec3::Constant(AxisPlace::kUnknownCoordinate);
  return outcome.toolpath->moves.back().end.tip;
}

/// Expects that blocks after the head are not clean, for a reason that contains `reason`.
inline void expect_open(const std::string& blocks, const std::string& reason, ProgramSetup setup = {}) {
  const ReadOutcome outcome = read_siemens(kHead + blocks + "\nM30\n", std::move(setup));
  EXPECT_FALSE(can_be_clean(outcome)) << blocks;
  EXPECT_NE(reasons_of(outcome).find(reason), std::string::npos) << blocks << "\n" << reasons_of(outcome);
}

inline void expect_at(const Vec3& tip, double x, double y, double z, double within = 1e-9) {
  EXPECT_NEAR((tip - Vec3(x, y, z)).norm(), 0, within) << tip.transpose();
}

}  // namespace gouge::test

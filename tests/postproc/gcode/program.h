#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "lib/machine/read_machine.h"
#include "postproc/gcode/reading/read_gcode.h"

// Programs as text, and what is read of them.

namespace gouge::test {

inline std::shared_ptr<const Machine> machine_of(const std::string& preset) {
  const MachinePreset* const found = find_preset(preset);
  if (found == nullptr) return nullptr;
  Result<Machine> machine = read_machine(preset, found->text);
  return machine ? std::make_shared<const Machine>(std::move(*machine)) : nullptr;
}

/// A C table on an A trunnion whose axes meet in the part zero.
inline std::shared_ptr<const Machine> trunnion() {
  Result<Machine> machine = read_machine("trunnion", R"({"name": "trunnion", "joints": [
    {"name": "C", "type": "rotary", "side": "table", "direction": [0, 0, 1], "point": [0, 0, 0], "continuous": true},
    {"name": "A", "type": "rotary", "side": "table", "direction": [1, 0, 0], "point": [0, 0, 0], "min": -120, "max": 120},
    {"name": "X", "type": "linear", "side": "head", "direction": [1, 0, 0]},
    {"name": "Y", "type": "linear", "side": "head", "direction": [0, 1, 0]},
    {"name": "Z", "type": "linear", "side": "head", "direction": [0, 0, 1]}]})");
  return machine ? std::make_shared<const Machine>(std::move(*machine)) : nullptr;
}

inline ReadOutcome read_program(const std::string& text, const std::string& control, ProgramSetup setup = {},
                                std::vector<std::string> harmless = {}) {
  setup.control = control;
  if (control == "linuxcnc") setup.start.insert(0, "G61\n");  // it begins with G64
  return read_gcode("program.nc", SourceText(text), {std::move(setup), std::nullopt, std::move(harmless), ""}, {});
}

/// Returns the path of what was read of a text; an empty one, with a failure, if it could not be read.
inline Toolpath path_in(ReadOutcome outcome, const std::string& text) {
  if (!outcome.toolpath) {
    ADD_FAILURE() << text << "\n" << (outcome.errors.empty() ? "no path" : to_text(outcome.errors.front()));
    return {};
  }
  return std::move(*outcome.toolpath);
}

/// Returns the path of a program that can be read.
inline Toolpath path_of_program(const std::string& text, const std::string& control, ProgramSetup setup = {}) {
  return path_in(read_program(text, control, std::move(setup)), text);
}

/// Returns whether a verdict on the path can be clean: every move is checked, and no word is unknown.
inline bool can_be_clean(const ReadOutcome& outcome) {
  if (!outcome.toolpath || !outcome.toolpath->words_not_understood.empty()) return false;
  for (const Move& move : outcome.toolpath->moves)
    if (!move.not_checked_reason.empty()) return false;
  for (const Assumption& fact : outcome.toolpath->assumptions)
    if (fact.basis == Basis::unknown || fact.basis == Basis::contradicted) return false;
  return true;
}

/// Returns the lines and reasons of all moves that are not checked, and all notes, with line ends between them.
inline std::string reasons_of(const ReadOutcome& outcome) {
  std::string all;
  if (!outcome.toolpath) return outcome.errors.empty() ? all : to_text(outcome.errors.front());
  for (const Move& move : outcome.toolpath->moves)
    if (!move.not_checked_reason.empty())
      all += std::to_string(move.line) + ": " + std::string(move.not_checked_reason) + "\n";
  for (const Diagnostic& note : outcome.toolpath->notes) all += note.message + "\n";
  return all;
}

inline void expect_open(const std::string& text, const std::string& control, const std::string& reason,
                        const ProgramSetup& setup = {}) {
  const ReadOutcome outcome = read_program(text, control, setup);
  EXPECT_FALSE(can_be_clean(outcome)) << text;
  EXPECT_NE(reasons_of(outcome).find(reason), std::string::npos) << text << "\n" << reasons_of(outcome);
}

inline void expect_checked(const std::string& text, const std::string& control, const ProgramSetup& setup = {}) {
  const ReadOutcome outcome = read_program(text, control, setup);
  EXPECT_TRUE(can_be_clean(outcome)) << text << "\n" << reasons_of(outcome);
}

inline void expect_tip(const Move& move, double x, double y, double z) {
  EXPECT_NEAR((move.end.tip - Vec3(x, y, z)).norm(), 0, 1e-9) << move.end.tip.transpose();
}

}  // namespace gouge::test

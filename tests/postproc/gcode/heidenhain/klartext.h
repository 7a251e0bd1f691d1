#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "lib/base/number_text.h"
#include "lib/machine/read_machine.h"
#include "postproc/gcode/reading/read_gcode.h"

// Reads Klartext of tests.

namespace gouge::klartext {

inline ReadOutcome outcome_of(const std::string& program, GcodeOptions options = {}) {
  options.setup.control = "heidenhain";
  options.setup.are_joint_rapids_straight = true;
  return read_gcode("test.h", program, options, {});
}

/// The path of a program, or an empty one after a test failure that shows the error.
inline Toolpath path_of(const std::string& program, const GcodeOptions& options = {}) {
  ReadOutcome outcome = outcome_of(program, options);
  if (!outcome.toolpath) {
    ADD_FAILURE() << (outcome.errors.empty() ? "no error told" : to_text(outcome.errors.front()));
    return {};
  }
  return std::move(*outcome.toolpath);
}

/// A whole program in mm of these blocks, with a tool.
inline std::string with_ends(const std::string& blocks) {
  return "0 BEGIN PGM TEST MM\n1 TOOL CALL 1 Z S5000\n" + blocks + "END PGM TEST MM\n";
}

inline Toolpath blocks_of(const std::string& blocks, const GcodeOptions& options = {}) {
  return path_of(with_ends(blocks), options);
}

/// A preset machine.
inline GcodeOptions on_machine(const std::string& name) {
  GcodeOptions options;
  const Result<Machine> machine = read_machine(name, find_preset(name)->text);
  if (!machine) ADD_FAILURE() << to_text(machine.error());
  if (machine) options.setup.machine = std::make_shared<const Machine>(*machine);
  return options;
}

/// The same machine with its rotary axes through the part zero.
inline GcodeOptions on_placed_machine(const std::string& name) {
  GcodeOptions options = on_machine(name);
  Machine placed = *options.setup.machine;
  for (Joint& joint : placed.joints) joint.has_point = true;
  options.setup.machine = std::make_shared<const Machine>(placed);
  options.setup.tool_length_mm = 100;
  options.setup.are_joint_rapids_straight = true;
  return options;
}

/// The tips of all moves as text: "(x, y, z)", with the reason of those that are not checked.
inline std::string tips(const Toolpath& path) {
  std::string text;
  for (const Move& move : path.moves) {
    text += text.empty() ? "" : " ";
    if (!move.not_checked_reason.empty()) {
      text += "open";
      continue;
    }
    for (int i = 0; i < 3; ++i) text += (i == 0 ? "(" : ",") + display_text(move.end.tip[i], 3);
    text += ")";
  }
  return text;
}

inline std::size_t count_open(const Toolpath& path) {
  std::size_t open = 0;
  for (const Move& move : path.moves) open += move.not_checked_reason.empty() ? 0U : 1U;
  return open;
}

/// The reason of the last move.
inline std::string last_reason(const Toolpath& path) {
  return path.moves.empty() ? "no move" : std::string(path.moves.back().not_checked_reason);
}

/// Expects that the last move of blocks is not checked, with a reason that contains a text, or that nothing is.
inline void expect_open(const std::string& blocks, const std::string& reason, const GcodeOptions& options = {}) {
  const ReadOutcome outcome = outcome_of(with_ends(blocks), options);
  const std::string found = outcome.toolpath         ? last_reason(*outcome.toolpath)
                            : outcome.errors.empty() ? "no error"
                                                     : to_text(outcome.errors.front());
  EXPECT_NE(found.find(reason), std::string::npos) << "found: " << found << "\nin: " << blocks;
}

}  // namespace gouge::klartext

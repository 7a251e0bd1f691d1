#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "postproc/gcode/language/control_table.h"
#include "postproc/gcode/lexing/variables.h"

// Values of words: numbers, variables, functions, and arithmetic in square brackets. Angles are in degrees.

namespace gouge {

/// A place in a text, and why its text is not understood.
struct GcodeCursor {
  std::string_view text;
  std::size_t at = 0;
  std::string error = {};   ///< empty: understood so far
  int depth = 0;            ///< brackets, signs and # in each other
  bool is_address = false;  ///< the value is that of an address
  bool is_rounded = false;  ///< a value that is read is calculated, and digits of the control round it

  [[nodiscard]] bool is_end() const { return at >= text.size(); }
  [[nodiscard]] char peek() const { return is_end() ? '\0' : text[at]; }
  void skip_blanks();
  void fail(std::string reason);
  /// Fails at a character with which no part of a block begins.
  void fail_at_character();
};

/// Reads a value at the cursor and moves the cursor behind it. Returns kUnknownValue for a value that depends on a
/// variable that is not known, or on a rule on which controls differ. On text that is no value, the cursor has an error.
/// `has_point`: the value is an expression, or a number with a decimal point.
/// Source   LinuxCNC, G-Code Overview, Expressions; Fanuc B-64484EN, Custom macro.
[[nodiscard]] double read_value(GcodeCursor& cursor, const GcodeSyntax& syntax, const GcodeVariables& variables,
                                bool& has_point);

/// Reads a number without sign that a double holds exactly but for one division, which rounds once. Nothing, with the cursor
/// where it was: another text.
[[nodiscard]] std::optional<double> read_plain_number(GcodeCursor& cursor, bool& has_point);

/// Reads an expression without brackets around it, which custom macros have on the right of an assignment.
[[nodiscard]] double read_expression(GcodeCursor& cursor, const GcodeSyntax& syntax, const GcodeVariables& variables);

/// Returns whether a variable is one of the control: its value is not known, and setting it changes offsets, lengths or such.
/// Source   LinuxCNC, G-Code Overview, Numbered parameters; Fanuc B-64484EN and Haas, Macros, system variables.
[[nodiscard]] bool is_system_variable(const std::string& name, const GcodeSyntax& syntax);

/// Reads the name of a variable behind its #: "101" or "<name>"; empty, with an error at the cursor: it is not known which
/// variable is meant.
[[nodiscard]] std::string read_variable_name(GcodeCursor& cursor, const GcodeSyntax& syntax,
                                             const GcodeVariables& variables);

}  // namespace gouge

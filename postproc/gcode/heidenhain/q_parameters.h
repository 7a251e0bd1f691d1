#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "postproc/gcode/language/gcode_block.h"

namespace gouge {

/// The Q parameters of a program: Q, QL and QR. A parameter that the program has not set is not known: an earlier program
/// or the control may have set it.
/// Source   iTNC 530 60642x-04, Q parameters: Q100 to Q199 are those of the control.
class QParameters {
 public:
  /// `name`: "Q5", "QL1" or "QR2".
  [[nodiscard]] double value(std::string_view name) const;
  void set(std::string_view name, double value);

 private:
  std::map<std::string, double, std::less<>> values_;
};

/// Reads the name of a parameter at the start of a text, and shortens the text. Empty: there is none.
[[nodiscard]] std::string take_parameter_name(std::string_view& text);

/// A value, and why its text is not understood.
struct FormulaValue {
  double value = kUnknownValue;
  std::string error;
};

/// Reads a formula to its end: + - * / ^, brackets, functions, PI. Angles are in degrees.
/// Source   iTNC 530 60642x-04, Entering formulas directly.
[[nodiscard]] FormulaValue read_formula(std::string_view text, const QParameters& parameters);

/// Reads a number or a parameter with its sign to the end of a text: "+5", "-Q2".
[[nodiscard]] FormulaValue read_operand(std::string_view text, const QParameters& parameters);

}  // namespace gouge

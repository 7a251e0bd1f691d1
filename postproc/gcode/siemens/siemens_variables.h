#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gouge {

enum class SiemensType : std::uint8_t { real, integer, boolean };

/// The variables of a Siemens program: R parameters, and those that DEF declares.
/// Source   Siemens, NC programming, 12/2019, 3.1.1 "User variables": DEF sets a variable to 0; a variable of a program is
///          not known in the programs that it calls. 2.2.2: leading zeros of the number of an address have no meaning, so
///          R01 is R1.
class SiemensVariables {
 public:
  SiemensVariables() : locals_(1) {}

  /// Returns whether the name, in capitals, is a variable of the program: R10, or one that DEF declares.
  [[nodiscard]] bool has(std::string_view name) const;
  /// Returns the value; kUnknownValue: the program has not set it.
  [[nodiscard]] double value(const std::string& name) const;
  /// Sets a variable. A value that its type does not hold makes it not known.
  void set(const std::string& name, double value);
  /// Declares a variable; false: its name is taken.
  [[nodiscard]] bool declare(const std::string& name, SiemensType type, double value);

  /// Returns R1 for R1, R01 and R001, and other names as they are.
  [[nodiscard]] static std::string one_spelling(const std::string& name);

  void begin_call() { locals_.emplace_back(); }
  /// Ends a subprogram. Requires begin_call before it.
  void end_call() { locals_.pop_back(); }

 private:
  struct Local {
    SiemensType type = SiemensType::real;
    double value = 0;
  };

  [[nodiscard]] static double held(SiemensType type, double value);

  std::map<std::string, double> parameters_;
  std::vector<std::map<std::string, Local, std::less<>>> locals_;
};

/// Returns whether a name in capitals is that of an R parameter: R10.
[[nodiscard]] bool is_r_parameter(std::string_view name);

}  // namespace gouge

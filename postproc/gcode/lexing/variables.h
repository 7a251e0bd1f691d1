#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "postproc/gcode/language/gcode_block.h"

namespace gouge {

/// The variables of a program: #1, #100, #<name>. A variable that the program has not set is not known: its value is one
/// of the control.
class GcodeVariables {
 public:
  GcodeVariables() : locals_(1) {}

  /// `name`: "101" or "<name>", as in GcodeAssignment.
  [[nodiscard]] double value(const std::string& name) const;
  /// `is_rounded`: other digits than those of doubles may give a value beside it.
  void set(const std::string& name, double value, bool is_rounded) {
    scope_of(name)[name] = value;
    if (is_rounded) rounded_.insert(name);
  }
  /// Returns whether a value of this name was ever rounded.
  [[nodiscard]] bool may_be_rounded(const std::string& name) const { return rounded_.contains(name); }

  /// Begins a subprogram, which has local variables of its own: #1 to #30, and names without a leading underscore.
  void begin_call() { locals_.emplace_back(); }
  /// Ends it. Requires begin_call before it.
  void end_call() { locals_.pop_back(); }
  [[nodiscard]] std::size_t depth() const { return locals_.size(); }

 private:
  using Values = std::map<std::string, double>;

  [[nodiscard]] static bool is_local(const std::string& name);
  Values& scope_of(const std::string& name) { return is_local(name) ? locals_.back() : globals_; }

  Values globals_;
  std::vector<Values> locals_;
  std::set<std::string> rounded_;
};

}  // namespace gouge

#pragma once

#include <cstddef>
#include <string>

#include "postproc/cldata/interpreting/statement_context.h"

namespace gouge {

/// The source language of APT, which gives values to symbols. It is refused, because CL data contain no such statement.
class PartProgram {
 public:
  explicit PartProgram(StatementContext& in) : in_(in) {}

  /// Returns whether the statement gives a value to a symbol; if so, it is taken.
  [[nodiscard]] bool take_assignment();
  /// Refuses noted assignments at the end of the file.
  void refuse_assignments();

 private:
  StatementContext& in_;
  std::string first_;  // the first assignment of a number to a symbol
  std::size_t first_line_ = 0;
};

}  // namespace gouge

#pragma once

#include <cstddef>
#include <string>

#include "postproc/cldata/interpreting/statement_context.h"

namespace gouge {

/// The source language of APT, which gives values to symbols: refused, because no CL data have them.
class PartProgram {
 public:
  explicit PartProgram(StatementContext& in) : in_(in) {}

  /// Returns true where the statement gives a symbol a value: then it is taken.
  [[nodiscard]] bool take_assignment();
  /// At the end of the file.
  void refuse_assignments();

 private:
  StatementContext& in_;
  std::string first_;  // assignment of a number to a symbol
  std::size_t first_line_ = 0;
};

}  // namespace gouge

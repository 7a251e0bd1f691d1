#pragma once

#include <optional>

#include "lib/base/diagnostic.h"
#include "lib/path/toolpath.h"

namespace gouge {

/// Either a toolpath or at least one error. At most 20 errors are listed, then one with the number of the rest.
/// Warnings and notes of a toolpath are in Toolpath::notes.
struct ReadOutcome {
  std::optional<Toolpath> toolpath;
  Diagnostics errors;
};

}  // namespace gouge

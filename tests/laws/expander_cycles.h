#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tests/laws/loose_statements.h"

// Drilling cycles for the mutation law's own reader, written from docs/formats/cycles.md.

namespace gouge::laws {

/// Heights above the position of a hole, in the unit of the file.
struct StatedCycle {
  double bottom = 0, clearance = 0, retract = 0;
};

/// Nothing, and why in `doubt`, where a word or a number of the statement is not understood, or contradicts
/// another.
[[nodiscard]] std::optional<StatedCycle> stated_cycle(const std::vector<LooseArgument>& arguments,
                                                      std::string_view dialect, std::string& uncertainty);

}  // namespace gouge::laws

#pragma once

#include <string>
#include <vector>

#include "lib/base/diagnostic.h"

namespace CLI {
class App;
}

// Lengths of the command line are in mm unless they carry a unit. Texts that state this wherever it matters.

namespace gouge {

/// Returns the rule as a sentence for the help of a command; empty where no option of it is a length.
[[nodiscard]] std::string length_rule(const CLI::App& command);

/// Returns the lengths that were typed without a unit, as "--tolerance 0.02". Those that are 0 in any unit are left
/// out.
/// Requires a command line that was parsed.
[[nodiscard]] std::vector<std::string> lengths_in_mm(const CLI::App& command);

/// Returns the note that these were taken in mm although `what` ("the toolpath") is in inches, and how to write inches.
/// Code: option-unit. Requires that there are some.
[[nodiscard]] Diagnostic describe_lengths_in_mm(const std::vector<std::string>& lengths, const std::string& what);

/// Returns a length, or lengths between commas, with "mm" behind each number that has no unit: "0.5mm,0mm,0.1in". Of
/// "x,y,z,rx,ry,rz" the angles stay as they are.
[[nodiscard]] std::string with_units(const std::string& typed);

}  // namespace gouge

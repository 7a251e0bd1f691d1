#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/output/outputs.h"
#include "lib/base/diagnostic.h"

namespace gouge {

/// A file that is read, and what it is: "the toolpath".
struct InputOption {
  std::string what, file;
};

/// Returns the inputs of `check` and `correct`.
[[nodiscard]] std::vector<InputOption> inputs_of(const JobArguments& arguments);

/// Returns why nothing may be written. An output, or a file that a report may replace or remove in its folder, is one
/// of the inputs or another output. Or it is the file that standard output goes to. Names count under any form (links,
/// ./, relative). Empty names and "-" are passed over. Code: usage.
[[nodiscard]] std::optional<Diagnostic> find_overwriting(const std::vector<InputOption>& inputs,
                                                         const OutputTable& outputs);

/// Returns where a name leads, also where nothing stands yet: the same text for every name of a place, links followed.
[[nodiscard]] std::string canonical_place(const std::string& name);

}  // namespace gouge

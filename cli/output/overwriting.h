#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/output/outputs.h"
#include "lib/base/diagnostic.h"

namespace gouge {

/// A file that is read, with its description: "the toolpath".
struct InputOption {
  std::string what, file;
};

/// Returns the inputs of `check` and `correct`.
[[nodiscard]] std::vector<InputOption> inputs_of(const JobArguments& arguments);

/// Returns why no output may be written. An output, or a file that a report may replace or remove in its folder, is one
/// of the inputs or another output. Or it is the file of standard output. Names are compared in any form (links, ./,
/// relative). Empty names and "-" are ignored. Code: usage.
[[nodiscard]] std::optional<Diagnostic> find_overwriting(const std::vector<InputOption>& inputs,
                                                         const OutputTable& outputs);

/// Returns the place to which a name leads, also if no file exists there yet. Links are followed, so all names of a
/// place give the same text.
[[nodiscard]] std::string canonical_place(const std::string& name);

}  // namespace gouge

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lib/base/diagnostic.h"
#include "lib/base/result.h"

// Names of jobs. The folders of a job have its name too, so not every name of a file can be one.

namespace gouge {

/// Returns why a job cannot have this name. Returns nothing if it can.
[[nodiscard]] std::optional<std::string> why_no_name(const std::string& name);

/// Replaces a name that no job can have by one made of it, and returns the error with which the job fails (job-name).
/// Returns nothing for any other name.
[[nodiscard]] std::optional<Diagnostic> replace_odd(std::string& name, const std::string& path);

/// Gives each toolpath a name of its own. Returns for each the error with which its job fails because of the name of its
/// file (job-name), or nothing. Errors: usage, if a toolpath is given twice.
[[nodiscard]] Result<std::vector<std::optional<Diagnostic>>> settle_names(const std::vector<std::string>& toolpaths,
                                                                          std::vector<std::string>& names);

}  // namespace gouge

#pragma once

#include <string>
#include <vector>

#include "lib/base/diagnostic.h"
#include "postproc/report/named_file.h"

namespace gouge {

/// Whether a report could write a file of this name: report.html, result.json, moves.csv and the pictures. Nothing
/// else in a folder is ours.
[[nodiscard]] bool is_name_of_report(const std::string& name);

/// Removes from `folder` what an older report left there under its own names and the new one, `files`, has not: it
/// would be taken for part of the new one. Errors: file-unwritable for each that cannot be removed.
[[nodiscard]] Diagnostics remove_older_report(const std::string& folder, const std::vector<NamedFile>& files);

}  // namespace gouge

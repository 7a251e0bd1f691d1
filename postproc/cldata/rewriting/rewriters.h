#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/diagnostic.h"
#include "lib/base/result.h"
#include "lib/path/path_change.h"
#include "lib/path/toolpath.h"
#include "postproc/cldata/interpreting/motion_records.h"
#include "postproc/program/edits.h"

// What write_corrected is made of.

namespace gouge {

/// Whether files of the dialect say RAPID of one motion, so that a feed can become a rapid.
[[nodiscard]] bool can_say_rapid(std::string_view dialect);

/// What is wrong with a list of changes whatever the file's statements are: a move named twice, changes that exclude
/// each other, arcs where the dialect cannot rewrite any. Nothing: write_corrected may look at the statements.
/// Errors   write-move, write-arc, write-alone, as write_corrected.
[[nodiscard]] std::optional<Diagnostic> find_wrong_change(const Toolpath& path, const std::vector<PathChange>& changes);

/// The edits of write_corrected for a file of text. Requires changes that write_corrected has checked.
/// Errors   write-arc, as write_corrected.
[[nodiscard]] Result<Edits> edits_of_text(const Toolpath& path, const MotionRecords& records,
                                          const std::vector<PathChange>& changes);

}  // namespace gouge

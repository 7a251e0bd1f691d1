#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/diagnostic.h"
#include "lib/base/result.h"
#include "lib/path/path_change.h"
#include "lib/path/toolpath.h"
#include "postproc/program/edits.h"

// What write_corrected is made of.

namespace gouge {

/// Whether files of the dialect say RAPID of one motion, so that a feed can become a rapid.
[[nodiscard]] bool can_say_rapid(std::string_view dialect);

/// What is wrong with a list of changes whatever the file's statements are: a move named twice, changes that exclude
/// each other, arcs where the dialect cannot rewrite any. Nothing: write_corrected may look at the statements.
/// Errors   write-move, write-arc, write-alone, as write_corrected.
[[nodiscard]] std::optional<Diagnostic> find_wrong_change(const Toolpath& path, const std::vector<PathChange>& changes);

/// The edits of write_corrected for a binary NCCS file: changed numbers are put into their records; where positions are
/// inserted or an arc becomes straight, one edit lays out all records in blocks anew and the record of the circle goes;
/// arcs on it that stay get one of their own.
/// A changed point of expanded motion becomes plain motion, as its other vectors no longer fit.
/// Requires changes that write_corrected has checked.
/// Ensures  Where no record comes or goes every byte of other numbers stays, the padding and what follows FINI too.
/// Errors   write-arc: an arc that stays begins where a change ends.
[[nodiscard]] Result<Edits> edits_of_nccs(const Toolpath& path, const std::vector<PathChange>& changes);

/// The edits of write_corrected for a Mastercam NCI file. Requires changes that write_corrected has checked.
/// Ensures  What write_corrected.h guarantees. An inserted position whose axis is not +Z, before a pair that
///          cannot say an axis, looks like the last five-axis line before it, or else the first one of the
///          file.
/// Errors   write-arc (an arc that stays begins at a position that moves), write-axis (an axis other than +Z for a pair
///          that has none, or for an inserted position in a file without five-axis lines).
[[nodiscard]] Result<Edits> edits_of_nci(const Toolpath& path, const std::vector<PathChange>& changes);

}  // namespace gouge

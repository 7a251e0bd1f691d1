#pragma once

#include <vector>

#include "lib/base/result.h"
#include "lib/path/path_change.h"
#include "postproc/cldata/interpreting/motion_records.h"
#include "postproc/program/edits.h"

namespace gouge {

/// Returns the edits of write_corrected for a Mastercam NCI file. Requires changes that write_corrected has checked.
/// Ensures  The guarantees of write_corrected.h. An inserted position may have an axis other than +Z before a pair that
///          cannot state an axis. It then has the form of the last five-axis line before it, or else of the first one
///          in the file.
/// Errors   (1) write-arc: an arc that stays begins at a position that moves. (2) write-axis: an axis other than +Z is
///          needed for a pair that has none, or for an inserted position in a file without five-axis lines.
[[nodiscard]] Result<Edits> edits_of_nci(const Toolpath& path, const MotionRecords& records,
                                         const std::vector<PathChange>& changes);

}  // namespace gouge

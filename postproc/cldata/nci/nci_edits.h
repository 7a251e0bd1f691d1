#pragma once

#include <vector>

#include "lib/base/result.h"
#include "lib/path/path_change.h"
#include "postproc/cldata/interpreting/motion_records.h"
#include "postproc/program/edits.h"

namespace gouge {

/// The edits of write_corrected for a Mastercam NCI file. Requires changes that write_corrected has checked.
/// Ensures  What write_corrected.h guarantees. An inserted position whose axis is not +Z, before a pair that
///          cannot state an axis, looks like the last five-axis line before it, or else the first one of the
///          file.
/// Errors   write-arc (an arc that stays begins at a position that moves), write-axis (an axis other than +Z for a pair
///          that has none, or for an inserted position in a file without five-axis lines).
[[nodiscard]] Result<Edits> edits_of_nci(const Toolpath& path, const MotionRecords& records,
                                         const std::vector<PathChange>& changes);

}  // namespace gouge

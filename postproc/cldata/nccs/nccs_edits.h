#pragma once

#include <vector>

#include "lib/base/result.h"
#include "lib/path/path_change.h"
#include "postproc/cldata/interpreting/motion_records.h"
#include "postproc/program/edits.h"

namespace gouge {

/// Returns the edits of write_corrected for a binary NCCS file. Changed numbers are put into their records. Where
/// positions are inserted or an arc becomes straight, one edit lays out all records in blocks anew. The record of the
/// circle goes; arcs on it that stay get one of their own. A changed point of expanded motion becomes plain motion, as
/// its other vectors no longer fit.
/// Requires changes that write_corrected has checked.
/// Ensures  Where no record comes or goes every byte of other numbers stays, the padding and the bytes after FINI too.
/// Errors   The code write-arc: an arc that stays begins where a change ends.
[[nodiscard]] Result<Edits> edits_of_nccs(const Toolpath& path, const MotionRecords& records,
                                          const std::vector<PathChange>& changes);

}  // namespace gouge

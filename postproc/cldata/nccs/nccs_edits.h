#pragma once

#include <vector>

#include "lib/base/result.h"
#include "lib/path/path_change.h"
#include "postproc/cldata/interpreting/motion_records.h"
#include "postproc/program/edits.h"

namespace gouge {

/// Returns the edits of write_corrected for a binary NCCS file. Changed numbers are put into their records. If
/// positions are inserted or an arc becomes straight, one edit lays out all records in new blocks. The record of the
/// circle is removed, and arcs on it that stay get a circle of their own. A changed point of expanded motion becomes
/// plain motion, because its other vectors are no longer right.
/// Requires changes that write_corrected has checked.
/// Ensures  If no record is added or removed, every byte except those of the changed numbers stays. That includes the
///          padding and the bytes after FINI.
/// Errors   The code write-arc: an arc that stays begins where a change ends.
[[nodiscard]] Result<Edits> edits_of_nccs(const Toolpath& path, const MotionRecords& records,
                                          const std::vector<PathChange>& changes);

}  // namespace gouge

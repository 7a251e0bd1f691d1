#pragma once

#include <string>

#include "postproc/report/report_model.h"

namespace gouge {

/// What `check` and `correct` print: one finding a line as compilers print them, in the order of the path,
/// then what was not checked or not certified, grouped by reason, then a summary of a few lines.
/// `path.apt:123: gouge: 0.213 mm cutter T1 at (12.3, 4.5, 6.7), move 118 t=0.42 (7 moves, 118-124)`
[[nodiscard]] std::string findings_text(const ReportModel& model);

/// The summary alone.
[[nodiscard]] std::string summary_text(const ReportModel& model);

}  // namespace gouge

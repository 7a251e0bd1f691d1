#pragma once

#include <string>

#include "postproc/report/report_model.h"

namespace gouge {

/// The result as JUnit XML, for build servers: one test case for each operation and tool, in path order.
/// A case fails on gouges and buried tools (named by the worst of them) and counts as skipped when it has
/// moves that could not be checked or certified. `time` of the suite is model.seconds; of a case its share by moves, as
/// all moves are swept together.
[[nodiscard]] std::string write_junit(const ReportModel& model);

}  // namespace gouge

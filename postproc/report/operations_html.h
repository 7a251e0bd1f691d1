#pragma once

#include <string>
#include <vector>

#include "lib/path/cycle_time.h"
#include "postproc/report/report_model.h"

namespace gouge {

/// Returns the operations with their cycle times and findings, as HTML, and states what the times leave out. `times` are
/// those of measure_cycle_times.
[[nodiscard]] std::string operations_html(const ReportModel& model, const std::vector<CycleTime>& times);

/// Returns the tools with their drawings and findings, as HTML. `drawings` has SVG for each tool; it may be empty.
[[nodiscard]] std::string tools_html(const ReportModel& model, const std::vector<std::string>& drawings);

/// Returns the cycle time in words, such as "2 min 5 s" or "at least 2 min 5 s"; empty if no feed is known.
[[nodiscard]] std::string cycle_time_text(const CycleTime& time);

/// Returns the time of all operations together.
[[nodiscard]] CycleTime whole_time(const std::vector<CycleTime>& times);

}  // namespace gouge

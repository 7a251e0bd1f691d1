#pragma once

#include <cstddef>
#include <vector>

#include "postproc/report/report_model.h"

namespace gouge {

/// Counts and maxima for the moves of one operation or tool.
struct Share {
  std::size_t moves = 0, findings = 0, cured = 0;
  double depth_mm = 0, overcut_mm = 0;
};

/// Returns the share of each operation, in their order, and last that of the moves without an operation.
[[nodiscard]] std::vector<Share> shares_of_operations(const ReportModel& model);
/// Returns the share of each tool, in their order, and last that of the moves without a tool.
[[nodiscard]] std::vector<Share> shares_of_tools(const ReportModel& model);
/// Returns the share of all moves together.
[[nodiscard]] Share sum_of(const std::vector<Share>& shares);

}  // namespace gouge

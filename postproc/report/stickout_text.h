#pragma once

#include <string>
#include <vector>

#include "postproc/report/report_model.h"

namespace gouge {

/// Describes the stick-out that the moves of a tool need: "74 mm; at 73 mm the holder gouges, line 18845".
[[nodiscard]] std::string stickout_need_text(const ReportModel& model, const StickoutFacts& tool,
                                             const StickoutNeed& need);

/// Returns the operations that need a longer stick-out than the tool has, if there are several operations.
[[nodiscard]] std::vector<OperationStickout> operations_in_need(const StickoutFacts& tool);
/// Returns the name of the operation, or its number if it has no name.
[[nodiscard]] std::string stickout_operation_label(const ReportModel& model, std::size_t operation);

/// Returns a line for each tool, and for each of its operations that need a longer stick-out.
[[nodiscard]] std::string stickout_lines(const ReportModel& model);

}  // namespace gouge

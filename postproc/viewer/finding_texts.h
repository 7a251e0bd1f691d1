#pragma once

#include <nlohmann/json.hpp>

#include "lib/field/checked_toolpath.h"
#include "postproc/report/report_model.h"

namespace gouge {

/// The findings for the viewer, one for each gouge, buried tool and near miss of the events, in their order: where the
/// tool is at the worst instant, the evidence, the numbers as the report writes them, and the lines of the file around
/// the statement. Lengths of coordinates in mm. At most `most` of them, the first.
[[nodiscard]] nlohmann::ordered_json finding_texts(const ReportModel& model, const CheckedToolpath& input,
                                                   std::size_t most);

}  // namespace gouge

#pragma once

#include <string>
#include <string_view>

#include "postproc/report/report_model.h"

namespace gouge {

/// Returns the data with which the page of a report keeps a review and exports acceptances: JSON that can stand in a
/// script element. `result` is the text of write_json of the same model, and `name` is the name of its file for the
/// command that the page shows. Findings beyond a total size have no entry; `gougecheck accept` accepts them. Empty if
/// there are no findings.
[[nodiscard]] std::string review_data(const ReportModel& model, const std::string& name, std::string_view result);

}  // namespace gouge

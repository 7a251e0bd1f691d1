#pragma once

#include <string>

#include "postproc/report/report_model.h"

namespace gouge {

/// The report as JSON: docs/formats/report_json.md, schema docs/formats/report.schema.json. Key order is
/// fixed, lengths are in the toolpath's unit and read back exactly, text is UTF-8.
[[nodiscard]] std::string write_json(const ReportModel& model);

}  // namespace gouge

#pragma once

#include <string>

#include "postproc/report/report_model.h"

namespace gouge {

/// One row for every move, header first; RFC 4180 with line feeds. Columns and their meaning:
/// docs/formats/csv.md. Lengths in the toolpath's unit, written so that they read back exactly.
[[nodiscard]] std::string write_csv(const ReportModel& model);

}  // namespace gouge

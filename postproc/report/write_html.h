#pragma once

#include <string>
#include <vector>

#include "postproc/report/named_file.h"
#include "postproc/report/report_model.h"

namespace gouge {

/// The report as one HTML page that needs nothing beside it: verdict, guarantee, pictures (embedded), findings,
/// the changes of a correction, what was not checked, inputs with checksums, options. Prints well on A4.
/// Long tables show their worst rows and say how many more there are; the CSV and JSON have them all.
/// `pictures` are PNG files named as by draw_report_pictures; event_N.png is linked from the findings.
[[nodiscard]] std::string write_html(const ReportModel& model, const std::vector<NamedFile>& pictures);

}  // namespace gouge

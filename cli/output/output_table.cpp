#include "cli/output/output_table.h"

#include <algorithm>

#include "postproc/report/report_model.h"
#include "postproc/report/write_report.h"

namespace gouge {
namespace {

void put_corrected(const ReportModel& model, const PutText& put) { put(model.correction.output_bytes); }

template <std::string (*write)(const ReportModel&)>
void put_whole(const ReportModel& model, const PutText& put) {
  put(write(model));
}

std::string certificate(const ReportModel& model) { return std::string(model.certificate_bytes); }

}  // namespace

OutputTable outputs_of(const JobArguments& a, const std::string& corrected) {
  OutputTable all = {{"-o", corrected, Output::Kind::file, put_corrected},
                     {"--json", a.json_file, Output::Kind::file, put_whole<write_json>},
                     {"--csv", a.csv_file, Output::Kind::file, put_csv},
                     {"--sarif", a.sarif_file, Output::Kind::file, put_whole<write_sarif>},
                     {"--junit", a.junit_file, Output::Kind::file, put_whole<write_junit>},
                     {"--certificate", a.certificate_file, Output::Kind::file, put_whole<certificate>},
                     {"--report", a.report_folder, Output::Kind::report_folder, nullptr}};
  for (const std::string& file : a.export_files)
    all.push_back({"--export", file, Output::Kind::file, nullptr, scene_format_of(file)});
  return asked_for(all);
}

OutputTable asked_for(const OutputTable& outputs) {
  OutputTable wanted;
  std::copy_if(outputs.begin(), outputs.end(), std::back_inserter(wanted),
               [](const Output& output) { return !output.file.empty(); });
  return wanted;
}

Result<bool> is_stdout_taken(const OutputTable& outputs) {
  const auto taken = std::ranges::count_if(
      outputs, [](const Output& output) { return output.kind == Output::Kind::file && output.file == "-"; });
  if (taken > 1) return make_error("usage", "only one output can go to standard output (-)");
  return taken == 1;
}

std::string report_folder_of(const OutputTable& outputs) {
  for (const Output& output : outputs) {
    if (output.kind == Output::Kind::report_folder) return output.file;
  }
  return {};
}

}  // namespace gouge

#include "cli/output/outputs.h"

#include <algorithm>
#include <ostream>

#include "cli/output/output_file.h"
#include "cli/output/overwriting.h"
#include "lib/base/exit_code.h"
#include "lib/base/printable_text.h"
#include "postproc/accept/review_data.h"
#include "postproc/export/make_export.h"
#include "postproc/image/report_pictures.h"
#include "postproc/image/tool_drawing.h"
#include "postproc/report/findings.h"
#include "postproc/report/report_model.h"
#include "postproc/report/report_text.h"
#include "postproc/report/write_report.h"
#include "postproc/viewer/write_viewer.h"

namespace gouge {

namespace {

CheckedToolpath pictures_of(const Job& job, const PreparedScene& scene, const Toolpath& path,
                            const CheckResult& result) {
  CheckedToolpath input;
  input.toolpath = &path;
  input.scene = &job.scene();
  input.prepared = &scene;
  input.tools = job.tools();
  input.result = &result;
  input.options = job.options.check;
  input.heads = job.heads();
  return input;
}

std::vector<std::string> drawings_of(const CheckedToolpath& input) {
  std::vector<std::string> drawings;
  for (std::size_t i = 0; i < input.tools.size(); ++i) {
    const auto& tool = input.tools[i];
    drawings.push_back(tool == nullptr ? std::string() : tool_drawing(tool->bare, tool_label(*input.toolpath, i)));
  }
  return drawings;
}

Diagnostics missing_letters(const ReportModel& model) {
  std::vector<std::string> meshes;
  for (const MeshFacts& mesh : model.parts) meshes.push_back(mesh.name);
  return find_missing_letters(*model.toolpath, meshes);
}

}  // namespace

JobOutputs::JobOutputs(const JobArguments& arguments, const std::string& corrected)
    : arguments_(arguments), outputs_(outputs_of(arguments, corrected)) {
  const std::string folder = report_folder_of(outputs_);
  if (folder.empty()) return;
  report_.emplace(folder, arguments.is_forced);
  report_->set_toolpath(arguments.path);
}

std::optional<int> JobOutputs::refuse(std::ostream& out, std::ostream& err) {
  const auto fail_all = [&](const Diagnostics& errors, int status) {
    print(err, errors);
    // An output that cannot be written has been reported.
    if (status != kExitUsage) (void)write_failure({arguments_.path, status, errors}, out);
    return status;
  };
  const RefusedOutputs refused = find_refused(inputs_of(arguments_), outputs_, !arguments_.batch_job.empty());
  if (!refused.errors.empty()) return fail_all(refused.errors, refused.status);
  if (!report_) return std::nullopt;
  const std::string batch = arguments_.batch_job.empty() ? batch_of_report(report_folder_of(outputs_)) : std::string();
  if (!batch.empty() && !arguments_.is_forced)
    return fail(
        err,
        {make_error("report-foreign",
                    "a report here would stand for that of a job of the batch " + batch + "; name another folder",
                    report_folder_of(outputs_))},
        kExitUsage);
  const Outcome opened = report_->open();
  if (!opened) return fail_all({opened.error()}, opened.error().code == "report-foreign" ? kExitUsage : kExitInternal);
  if (const std::string& other = report_->replaced_toolpath(); !other.empty() && !arguments_.is_quiet)
    print(err, {make_note("report-replaced", "holds the report of " + other + ", which this one replaces",
                          report_folder_of(outputs_))});
  const Outcome loaded = load_pictures();
  if (!loaded) return fail_all({loaded.error()}, kExitInternal);
  return std::nullopt;
}

bool JobOutputs::write(const Job& job, const PreparedScene& scene, const ReportModel& model, Progress& progress,
                       std::ostream& out, std::ostream& err) {
  const Outcome written = write_files(job, scene, model, progress, out);
  progress.end();
  if (written && report_ && !arguments_.is_quiet) print(err, missing_letters(model));
  print_findings(model, written.has_value(), out);
  const Result<bool> taken = is_stdout_taken(outputs_);
  const bool is_silent = arguments_.is_quiet || !taken || *taken;
  if (is_silent && !arguments_.is_verbose && arguments_.project_file)
    print(err, {make_note(kProjectFile, arguments_.project_file->summary, arguments_.project_file->input.name)});
  if (!written) {
    out.flush();  // where both streams go to one place, the error must stand below the findings
    print(err, {written.error()});
    // Replaces files that were put in place before the error, or that hold the result of an earlier run.
    (void)write_failure({arguments_.path, kExitInternal, {written.error()}}, out);
  }
  return written.has_value();
}

Outcome JobOutputs::write_failure(const FailedRun& run, std::ostream& out) const {
  if (find_overwriting(inputs_of(arguments_), outputs_) || !is_stdout_taken(outputs_)) return Done{};
  Outcome all = Done{};
  for (const Output& output : outputs_) {
    if (output.write_failure == nullptr) continue;
    if (const Outcome one = write_output(output.file, output.write_failure(run), out); !one && all) all = one;
  }
  return all;
}

Outcome JobOutputs::write_files(const Job& job, const PreparedScene& scene, const ReportModel& model,
                                Progress& progress, std::ostream& out) {
  PendingOutputs pending;
  if (report_) {
    if (Outcome staged = stage_report(job, scene, model, progress); !staged) return staged;
  }
  std::optional<ExportScene> exported;
  for (const Output& output : outputs_) {
    progress.begin(output.file == "-" ? "writing" : "writing " + output.file);
    if (output.write_scene != nullptr) {
      if (!exported)
        exported = make_export(model, pictures_of(job, scene, *model.toolpath, *model.result), progress.call());
      const Result<std::string> bytes = output.write_scene(*exported);
      if (!bytes) return bytes.error();
      if (Outcome added = pending.add(output.file, *bytes); !added) return added;
    }
    if (output.write == nullptr || (output.has_content != nullptr && !output.has_content(model))) continue;
    const TextWriter write = [&](const PutText& put) { output.write(model, put); };
    if (Outcome added = pending.add(output.file, write); !added) return added;
  }
  if (report_) {
    if (Outcome put = report_->commit(); !put) return put;
  }
  progress.end();  // the line may share the terminal with standard output
  return pending.commit(out);
}

Outcome JobOutputs::stage_report(const Job& job, const PreparedScene& scene, const ReportModel& model,
                                 Progress& progress) {
  CheckedToolpath before;
  if (model.has_correction)
    before = pictures_of(job, scene, *model.correction.toolpath_before, *model.correction.result_before);
  const CheckedToolpath input = pictures_of(job, scene, *model.toolpath, *model.result);
  progress.begin("preparing the pictures");
  const ReportScene shown(model, input, before);
  Result<std::vector<NamedFile>> drawn = draw_report_pictures(shown, progress.call());
  if (!drawn) return drawn.error();
  std::vector<NamedFile> files = std::move(*drawn);
  const Result<std::string> view = write_viewer(shown, progress.call());
  if (!view) return view.error();
  progress.begin("writing the report");
  const std::string result = write_json(model);
  const std::string review = model.has_correction ? std::string() : review_data(model, "result.json", result);
  files.push_back({"report.html", write_html(model, files, {*view, drawings_of(input), review}), ""});
  files.push_back({"result.json", result, ""});
  files.push_back({"moves.csv", write_csv(model), ""});
  return report_->stage(files);
}

void JobOutputs::print_findings(const ReportModel& model, bool is_written, std::ostream& out) const {
  const Result<bool> taken = is_stdout_taken(outputs_);
  if (arguments_.is_quiet || !taken || *taken) return;
  ReportModel reported = model;
  if (!is_written) reported.correction.output_file.clear();
  out << findings_text(reported, view_on(out, arguments_.listing, arguments_.is_verbose));
  if (is_written && report_) out << "report: " << printable(report_folder_of(outputs_)) << "/report.html\n";
}

namespace {

void put_corrected(const ReportModel& model, const PutText& put) { put(model.correction.output_bytes); }

template <std::string (*write)(const ReportModel&)>
void put_whole(const ReportModel& model, const PutText& put) {
  put(write(model));
}

template <std::string (*write)(const ReportModel&), std::string (*write_failed)(const FailedRun&)>
Output for_build_server(const char* option, const std::string& file) {
  Output output{option, file, Output::Kind::file, put_whole<write>};
  output.write_failure = write_failed;
  return output;
}

std::string certificate(const ReportModel& model) { return std::string(model.certificate_bytes); }

template <std::string_view StockLeft::*bytes>
Output stock_output(const std::string& file) {
  Output output{"--write-stock", file};
  output.write = [](const ReportModel& model, const PutText& put) { put((*model.stock_left).*bytes); };
  output.has_content = [](const ReportModel& model) {
    return model.stock_left.has_value() && !((*model.stock_left).*bytes).empty();
  };
  return output;
}

}  // namespace

OutputTable outputs_of(const JobArguments& a, const std::string& corrected) {
  OutputTable all = {{"-o", corrected, Output::Kind::file, put_corrected},
                     {"--json", a.json_file, Output::Kind::file, put_whole<write_json>},
                     {"--csv", a.csv_file, Output::Kind::file, put_csv},
                     for_build_server<write_sarif, write_sarif>("--sarif", a.sarif_file),
                     for_build_server<write_junit, write_junit>("--junit", a.junit_file),
                     {"--certificate", a.certificate_file, Output::Kind::file, put_whole<certificate>},
                     {"--report", a.report_folder, Output::Kind::report_folder, nullptr}};
  if (!a.write_stock.empty()) {
    all.push_back(stock_output<&StockLeft::perhaps_stl>(a.write_stock));
    all.push_back(stock_output<&StockLeft::surely_stl>(surely_file_of(a.write_stock)));
  }
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

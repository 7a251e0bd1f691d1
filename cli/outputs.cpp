#include "cli/outputs.h"

#include <ostream>

#include "cli/picture_file.h"
#include "cli/report_folder.h"
#include "lib/base/files.h"
#include "lib/base/printable_text.h"
#include "postproc/image/report_pictures.h"
#include "postproc/report/findings_text.h"
#include "postproc/report/write_csv.h"
#include "postproc/report/write_html.h"
#include "postproc/report/write_json.h"
#include "postproc/report/write_junit.h"
#include "postproc/report/write_sarif.h"

namespace gouge {
namespace {

struct Writer {
  const std::string& file;
  std::string (*write)(const ReportModel&);
};

bool deliver(const std::string& file, const std::string& bytes, std::ostream& out, std::ostream& err) {
  if (file == "-") {
    out << bytes;
    return true;
  }
  const Outcome written = write_file(file, bytes);
  if (!written) print(err, {written.error()});
  return written.has_value();
}

PictureInput pictures_of(const Job& job, const Toolpath& path, const CheckResult& result) {
  PictureInput input;
  input.toolpath = &path;
  input.scene = &job.scene;
  input.tools = job.tools();
  input.result = &result;
  input.options = job.options.check;
  input.heads = job.heads;
  return input;
}

bool write_report(const JobArguments& arguments, const Job& job, const ReportModel& model, Progress& progress,
                  std::ostream& out, std::ostream& err) {
  const std::string& folder = arguments.report_folder;
  const Outcome made = make_folder(folder);
  if (!made) {
    print(err, {made.error()});
    return false;
  }
  progress.begin("drawing the report");
  PictureInput before;
  if (model.has_correction)
    before = pictures_of(job, *model.correction.toolpath_before, *model.correction.result_before);
  Result<std::vector<NamedFile>> drawn =
      draw_report_pictures(model, pictures_of(job, *model.toolpath, *model.result), before);
  progress.end();
  if (!drawn) {
    print(err, {drawn.error()});
    return false;
  }
  std::vector<std::string> meshes;
  for (const MeshFacts& mesh : model.parts) meshes.push_back(mesh.name);
  if (!arguments.is_quiet) print(err, find_missing_letters(*model.toolpath, meshes));
  std::vector<NamedFile> files = std::move(*drawn);
  files.push_back({"report.html", write_html(model, files), ""});
  files.push_back({"result.json", write_json(model), ""});
  files.push_back({"moves.csv", write_csv(model), ""});
  bool is_good = true;
  for (const NamedFile& file : files)
    is_good = deliver(folder + "/" + file.name, file.bytes, out, err) && is_good;
  const Diagnostics kept = remove_older_report(folder, files);
  print(err, kept);
  return is_good && kept.empty();
}

}  // namespace

void print(std::ostream& err, const Diagnostics& diagnostics) {
  for (const Diagnostic& d : diagnostics) err << to_text(d) << "\n";
}

void print_notes(std::ostream& err, const Diagnostics& notes, const JobArguments& arguments) {
  constexpr std::size_t kMost = 10;
  if (arguments.is_verbose) return print(err, notes);
  if (arguments.is_quiet) return;
  std::size_t warnings = 0;
  for (const Diagnostic& d : notes) {
    if (d.severity == Severity::warning && ++warnings <= kMost) err << to_text(d) << "\n";
  }
  if (warnings > kMost) err << "gougecheck: " << warnings - kMost << " more warnings; -v shows all\n";
}

Result<bool> is_stdout_taken(const JobArguments& a, const std::string& corrected) {
  int taken = 0;
  for (const std::string* file : {&corrected, &a.json_file, &a.csv_file, &a.sarif_file, &a.junit_file})
    taken += *file == "-";
  if (taken > 1) return make_error("usage", "only one output can go to standard output (-)");
  return taken == 1;
}

bool write_outputs(const JobArguments& arguments, const Job& job, const ReportModel& model,
                   Progress& progress, std::ostream& out, std::ostream& err) {
  const Result<bool> taken = is_stdout_taken(arguments, model.correction.output_file);
  if (taken && !*taken && !arguments.is_quiet) out << findings_text(model);
  bool is_good = true;
  for (const Writer& writer :
       {Writer{arguments.json_file, write_json}, Writer{arguments.csv_file, write_csv},
        Writer{arguments.sarif_file, write_sarif}, Writer{arguments.junit_file, write_junit}}) {
    if (!writer.file.empty()) is_good = deliver(writer.file, writer.write(model), out, err) && is_good;
  }
  if (!arguments.report_folder.empty()) {
    is_good = write_report(arguments, job, model, progress, out, err) && is_good;
    if (is_good && taken && !*taken && !arguments.is_quiet) {
      out << "report: " << printable(arguments.report_folder) << "/report.html\n";
    }
  }
  return is_good;
}

}  // namespace gouge

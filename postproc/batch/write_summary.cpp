#include "postproc/batch/write_summary.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "lib/base/number_text.h"
#include "lib/base/printable_text.h"
#include "postproc/report/csv_row.h"
#include "postproc/report/report_text.h"

namespace gouge {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kColumns =
    "job,command,path,status,verdict,moves,clean,near,gouge,buried,not_checked,not_certified,findings,deepest,unit,"
    "deepest_line,report,seconds,memory_mb,host,rank\n";

void add_counts(CsvRow& row, const JobResult& job) {
  const StateCounts& n = job.counts;
  for (const std::size_t count :
       {job.moves(), n.clean, n.near_miss, n.gouge, n.buried, n.not_checked, n.not_certified, job.gouge_findings()})
    row.count(count);
}

void add_row(const JobResult& job, std::string& csv) {
  CsvRow row(csv);
  row.text(without_formula(job.name));
  row.word(job.command);
  row.text(without_formula(job.toolpath));
  row.word(job.status ? std::to_string(*job.status) : "");
  row.word(job.verdict());
  add_counts(row, job);
  job.deepest ? row.number(*job.deepest) : row.empty(1);
  row.word(job.unit);
  row.word(job.deepest ? std::to_string(job.deepest_line) : "");
  row.text(without_formula(job.report));
  row.word(fixed_text(job.seconds, 3));
  row.word(fixed_text(job.memory_mb, 0));
  row.text(without_formula(job.host));
  row.word(std::to_string(job.rank));
}

Json inputs_of(const JobResult& job) {
  Json inputs = Json::array();
  for (const InputFile& file : job.inputs) {
    inputs.push_back(
        {{"role", file.role}, {"file", valid_utf8(file.name)}, {"bytes", file.bytes}, {"checksum", file.checksum}});
  }
  return inputs;
}

Json outputs_of(const JobResult& job) {
  Json outputs = Json::array();
  for (const JobOutput& file : job.outputs)
    outputs.push_back({{"file", valid_utf8(file.file)}, {"bytes", file.bytes}, {"sha256", file.sha256}});
  return outputs;
}

Json object_of(const JobResult& job) {
  const StateCounts& n = job.counts;
  Json messages = Json::array();
  for (const std::string& one : job.remarks()) messages.push_back(valid_utf8(one));
  Json object = {{"job", valid_utf8(job.name)},
                 {"command", job.command},
                 {"path", valid_utf8(job.toolpath)},
                 {"status", job.status ? Json(*job.status) : Json(nullptr)},
                 {"verdict", job.verdict()},
                 {"unit", job.unit.empty() ? Json(nullptr) : Json(job.unit)},
                 {"moves", job.moves()},
                 {"counts",
                  {{"clean", n.clean},
                   {"near", n.near_miss},
                   {"gouge", n.gouge},
                   {"buried", n.buried},
                   {"not_checked", n.not_checked},
                   {"not_certified", n.not_certified},
                   {"skipped", n.skipped}}},
                 {"findings", job.gouge_findings()},
                 {"deepest", job.deepest ? Json(*job.deepest) : Json(nullptr)},
                 {"deepest_line", job.deepest ? Json(job.deepest_line) : Json(nullptr)},
                 {"report", job.report.empty() ? Json(nullptr) : Json(valid_utf8(job.report))},
                 {"inputs", inputs_of(job)},
                 {"outputs", outputs_of(job)},
                 {"messages", messages}};
  object["seconds"] = job.seconds;
  object["memory_mb"] = job.memory_mb;
  object["host"] = valid_utf8(job.host);
  object["rank"] = job.rank;
  return object;
}

JunitCase case_without_result(const JobResult& job) {
  JunitCase one;
  one.name = job.name;
  if (!job.status) {
    one.skipped_message = "the job has not run";
  } else {
    one.error_message = "exit status " + std::to_string(*job.status);
    for (const std::string& remark : job.remarks()) one.error_message += "; " + remark;
  }
  return one;
}

// Adds a note for each place of material that is left on the parts, as the SARIF of a single check has.
void add_material_left(const JobResult& job, SarifJob& sarif) {
  const auto found = std::ranges::find(job.cases, kExcessCase, &JunitCase::name);
  if (found == job.cases.end()) return;
  std::istringstream places(found->failure_text);
  const char* const level = found->failure_type.empty() ? "warning" : "error";
  for (std::string place; std::getline(places, place);) sarif.notes.push_back({level, "material-left", place});
}

}  // namespace

std::string write_summary_csv(const std::vector<JobResult>& jobs) {
  std::string csv(kColumns);
  for (const JobResult& job : jobs) add_row(job, csv);
  return csv;
}

std::string write_summary_json(const std::vector<JobResult>& jobs) {
  Json all = Json::array();
  for (const JobResult& job : jobs) all.push_back(object_of(job));
  const Json root = {{"format", "gougecheck-batch"},
                     {"format_version", 1},
                     {"program", {{"name", kProgramName}, {"version", kProgramVersion}}},
                     {"exit_status", batch_status(jobs)},
                     {"jobs", all}};
  return root.dump(1) + "\n";
}

std::string write_batch_sarif(const std::vector<JobResult>& jobs) {
  std::vector<SarifJob> all;
  for (const JobResult& job : jobs) {
    if (!job.status) continue;
    SarifJob one{job.toolpath, *job.status, {}, job.findings};
    for (const Diagnostic& warning : job.warnings()) one.notes.push_back(sarif_note_of(warning));
    add_material_left(job, one);
    if (job.unit.empty()) {
      for (const std::string& remark : job.remarks()) one.notes.push_back({"error", "job-failed", remark});
    }
    all.push_back(std::move(one));
  }
  return write_sarif(all);
}

std::string write_batch_junit(const std::vector<JobResult>& jobs) {
  std::vector<JunitSuite> suites;
  for (const JobResult& job : jobs) {
    JunitSuite suite{job.toolpath, job.name, job.seconds, job.moves(), job.cases, job.beside};
    if (job.cases.empty()) suite.cases.push_back(case_without_result(job));
    suites.push_back(std::move(suite));
  }
  return write_junit(suites);
}

}  // namespace gouge

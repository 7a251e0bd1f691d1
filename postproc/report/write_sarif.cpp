#include "postproc/report/write_report.h"

#include <array>
#include <map>
#include <nlohmann/json.hpp>

#include "lib/base/printable_text.h"
#include "postproc/report/excess_text.h"
#include "postproc/report/findings.h"
#include "postproc/report/report_text.h"

namespace gouge {
namespace {

using Json = nlohmann::ordered_json;

struct Rule {
  MoveState state;
  const char* level;
  const char* meaning;
};

constexpr std::array<Rule, 5> kRules{{
    {MoveState::gouge, "error", "The tool cuts deeper into the part, or closer to it, than is allowed"},
    {MoveState::buried, "error", "The tool lies inside a closed solid with no surface within the tool"},
    {MoveState::near_miss, "note", "The tool comes closer than the near-miss distance asked for"},
    {MoveState::not_checked, "warning", "The motion could not be checked"},
    {MoveState::not_certified, "warning", "The check did not reach its resolution within its budget"},
}};

std::size_t rule_index(MoveState state) {
  for (std::size_t i = 0; i < kRules.size(); ++i) {
    if (kRules[i].state == state) return i;
  }
  return 0;
}

class SarifReport {
 public:
  explicit SarifReport(const std::vector<SarifJob>& jobs) : jobs_(jobs) {}

  [[nodiscard]] Json build() {
    Json rules = Json::array(), invocations = Json::array(), artifacts = Json::array();
    for (const Rule& rule : kRules) {
      rules.push_back({{"id", state_name(rule.state)},
                       {"shortDescription", {{"text", rule.meaning}}},
                       {"defaultConfiguration", {{"level", rule.level}}}});
    }
    for (std::size_t job = 0; job < jobs_.size(); ++job) {
      invocations.push_back({{"executionSuccessful", is_verdict(jobs_[job].exit_status)},
                             {"exitCode", jobs_[job].exit_status},
                             {"toolExecutionNotifications", notifications(jobs_[job].notes)}});
      artifacts.push_back({{"location", {{"uri", uri_of(jobs_[job].toolpath)}}}});
      for (const Finding& finding : jobs_[job].findings) add(finding, job);
    }
    Json run;
    run["tool"] = {{"driver", {{"name", kProgramName}, {"version", kProgramVersion}, {"rules", rules}}}};
    run["invocations"] = invocations;
    run["artifacts"] = artifacts;
    run["columnKind"] = "utf16CodeUnits";
    run["results"] = results_;
    return {{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
            {"version", "2.1.0"},
            {"runs", Json::array({run})}};
  }

 private:
  [[nodiscard]] static bool is_verdict(int status) {
    return status == kExitClean || status == kExitGouges || status == kExitNotChecked;
  }

  [[nodiscard]] static Json notifications(const std::vector<SarifNote>& notes) {
    Json all = Json::array();
    for (const SarifNote& note : notes) {
      all.push_back({{"level", note.level},
                     {"message", {{"text", valid_utf8(note.text)}}},
                     {"descriptor", {{"id", valid_utf8(note.code)}}}});
    }
    return all;
  }

  void add(const Finding& finding, std::size_t job) {
    const std::size_t occurrence = ++seen_[finding.fingerprint];
    Json location = {{"artifactLocation", {{"uri", uri_of(jobs_[job].toolpath)}, {"index", job}}}};
    if (finding.line > 0) location["region"] = {{"startLine", finding.line}};
    const std::size_t rule = rule_index(finding.state);
    Json result = {
        {"ruleId", state_name(finding.state)},
        {"ruleIndex", rule},
        {"level", kRules.at(rule).level},
        {"message", {{"text", valid_utf8(finding.message)}}},
        {"locations", Json::array({{{"physicalLocation", location}}})},
        {"partialFingerprints", {{"gougecheckFinding/v2", finding.fingerprint + ":" + std::to_string(occurrence)}}}};
    if (!finding.against.empty()) result["properties"] = {{"obstacle", valid_utf8(finding.against)}};
    if (!finding.baseline_state.empty()) {
      result["baselineState"] = finding.baseline_state;
      result["suppressions"] = suppressions(finding);
    }
    results_.push_back(std::move(result));
  }

  // Returns the suppressions of a finding. An empty list means that it was reviewed and not accepted.
  [[nodiscard]] static Json suppressions(const Finding& finding) {
    if (finding.justification.empty()) return Json::array();
    return Json::array(
        {{{"kind", "external"}, {"status", "accepted"}, {"justification", valid_utf8(finding.justification)}}});
  }

  const std::vector<SarifJob>& jobs_;
  Json results_ = Json::array();
  std::map<std::string, std::size_t> seen_;
};

}  // namespace

SarifNote sarif_note_of(const Diagnostic& diagnostic) {
  return {diagnostic.severity == Severity::error ? "error" : "warning", diagnostic.code, to_text(diagnostic)};
}

SarifJob sarif_job_of(const ReportModel& model) {
  SarifJob job{model.toolpath->file, exit_status(overall_verdict(model)), {}, list_findings(model)};
  for (const Diagnostic& note : model.notes) {
    if (note.severity == Severity::warning) job.notes.push_back(sarif_note_of(note));
  }
  if (model.result->excess) {
    for (const ExcessPlaceFacts& place : model.result->excess->places) {
      job.notes.push_back(
          {place.is_proved() ? "error" : "warning", "material-left",
           model.parts[place.part].name + ": " + excess_kind(place) + ": " + excess_place_text(model, place)});
    }
  }
  return job;
}

std::string write_sarif(const std::vector<SarifJob>& jobs) { return SarifReport(jobs).build().dump(1) + "\n"; }

std::string write_sarif(const ReportModel& model) { return write_sarif(std::vector{sarif_job_of(model)}); }

std::string write_sarif(const FailedRun& run) {
  SarifJob job{run.toolpath, run.exit_status, {}, {}};
  for (const Diagnostic& error : run.errors) job.notes.push_back(sarif_note_of(error));
  return write_sarif({job});
}

}  // namespace gouge

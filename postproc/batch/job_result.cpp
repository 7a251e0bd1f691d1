#include "postproc/batch/job_result.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <numeric>
#include <set>
#include <sstream>
#include <string_view>
#include <utility>

#include "lib/base/exit_code.h"
#include "lib/path/assumption.h"
#include "postproc/report/report_text.h"

namespace gouge {

std::size_t JobResult::moves() const {
  return counts.clean + counts.near_miss + counts.gouge + counts.buried + counts.not_checked + counts.not_certified;
}

namespace {

// Returns whether material left on the part is all that failed.
bool has_only_excess(const std::vector<JunitCase>& cases) {
  const auto failed = [&](bool is_excess) {
    return std::ranges::any_of(cases, [is_excess](const JunitCase& one) {
      return !one.failure_type.empty() && (one.failure_type == kExcessFailure) == is_excess;
    });
  };
  return failed(true) && !failed(false);
}

}  // namespace

std::size_t JobResult::gouge_findings() const {
  return static_cast<std::size_t>(std::ranges::count_if(findings, [](const Finding& finding) {
    return finding.state == MoveState::gouge || finding.state == MoveState::buried;
  }));
}

Diagnostics JobResult::warnings() const {
  Diagnostics warnings;
  std::ranges::copy_if(notes, std::back_inserter(warnings),
                       [](const Diagnostic& note) { return note.severity == Severity::warning; });
  return warnings;
}

std::vector<std::string> JobResult::remarks() const {
  std::vector<std::string> remarks;
  for (const Diagnostic& warning : warnings()) remarks.push_back(to_text(warning));
  if (counts.skipped > 0) remarks.push_back(left_out_text(counts.skipped));
  if (!unit.empty()) return remarks;
  std::istringstream lines(messages);
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty()) remarks.push_back(line);
  }
  return remarks;
}

const char* JobResult::verdict() const {
  if (!status) return "not-run";
  if (*status == kExitClean)
    return verdict_name(gouge_findings() > 0 ? OverallVerdict::accepted_gouges : OverallVerdict::clean);
  if (*status == kExitNotChecked) return verdict_name(OverallVerdict::not_fully_checked);
  // `correct` also has this status if it refuses a path that clearly does not fit the part; then no check was
  // completed.
  if (*status == kExitGouges && !unit.empty())
    return verdict_name(has_only_excess(cases) ? OverallVerdict::material_left : OverallVerdict::gouges);
  return "failed";
}

int severity_of(std::optional<int> status) {
  constexpr std::array kFromWorst = {kExitInternal, kExitUsage, kExitInput, kExitGouges, kExitNotChecked, kExitClean};
  const auto* const found = std::ranges::find(kFromWorst, status.value_or(kExitNotChecked));
  return found == kFromWorst.end() ? -1 : static_cast<int>(found - kFromWorst.begin());
}

int batch_status(const std::vector<JobResult>& jobs) {
  int worst = kExitClean;
  for (const JobResult& job : jobs) {
    if (severity_of(job.status) < severity_of(worst)) worst = job.status.value_or(kExitNotChecked);
  }
  return worst;
}

std::vector<std::size_t> worst_first(const std::vector<JobResult>& jobs) {
  std::vector<std::size_t> order(jobs.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const int of_a = severity_of(jobs[a].status), of_b = severity_of(jobs[b].status);
    return of_a != of_b ? of_a < of_b : jobs[a].deepest_mm > jobs[b].deepest_mm;
  });
  return order;
}

std::string verdict_counts(const std::vector<JobResult>& jobs) {
  std::string text;
  for (const std::string_view verdict :
       {"failed", "gouges", "material-left", "not-fully-checked", "accepted-gouges", "clean", "not-run"}) {
    const auto count = std::ranges::count_if(jobs, [&](const JobResult& job) { return job.verdict() == verdict; });
    if (count == 0) continue;
    text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + std::string(verdict);
  }
  return text;
}

std::optional<TwoContents> find_two_contents(const std::vector<JobResult>& jobs) {
  std::map<std::string, std::pair<std::string, std::size_t>> contents;
  for (std::size_t k = 0; k < jobs.size(); ++k) {
    for (const InputFile& input : jobs[k].inputs) {
      const auto [first, is_new] = contents.try_emplace(input.name, input.checksum, k);
      if (!is_new && first->second.first != input.checksum)
        return TwoContents{input.role, input.name, false, first->second.second, k};
    }
  }
  std::map<FileSearch, std::pair<std::vector<std::string>, std::size_t>> searches;
  for (std::size_t k = 0; k < jobs.size(); ++k) {
    for (const auto& [search, found] : jobs[k].searches) {
      const auto [first, is_new] = searches.try_emplace(search, found, k);
      if (!is_new && first->second.first != found)
        return TwoContents{rule_name(search.rule), place_of(search), true, first->second.second, k};
    }
  }
  return std::nullopt;
}

namespace {

// Returns the notes of a report. The facts that are open come first, because a page may show the first note only.
Diagnostics gravest_first(const ReportModel& model) {
  std::set<std::string> contradicted, open;
  for (const Assumption& fact : model.result->assumptions) {
    for (const Diagnostic& warning : open_warnings({fact}))
      (fact.basis == Basis::contradicted ? contradicted : open).insert(to_text(warning));
  }
  const auto rank = [&](const Diagnostic& note) {
    const std::string text = to_text(note);
    return contradicted.contains(text) ? 0 : open.contains(text) ? 1 : 2;
  };
  Diagnostics notes = model.notes;
  std::ranges::stable_sort(notes, {}, rank);
  return notes;
}

}  // namespace

void take_report(const ReportModel& model, JobResult& result) {
  const LengthUnit unit = model.toolpath->unit;
  result.unit = unit_name(unit);
  result.counts = model.result->counts;
  if (result.counts.gouge > 0) {
    result.deepest_mm = model.result->worst_depth_mm;
    result.deepest = result.deepest_mm / mm_per(unit);
    result.deepest_line = model.toolpath->moves[model.result->worst_move].line;
  }
  result.findings = list_findings(model);
  result.notes = gravest_first(model);
  const JunitSuite suite = junit_suite_of(model);
  result.cases = suite.cases;
  result.beside = suite.beside;
  result.inputs = model.inputs;
}

}  // namespace gouge

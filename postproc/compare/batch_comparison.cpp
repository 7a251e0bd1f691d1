#include "postproc/compare/batch_comparison.h"

#include <algorithm>

#include "lib/base/number_text.h"
#include "lib/base/printable_text.h"
#include "postproc/compare/comparison_object.h"
#include "postproc/compare/write_comparison.h"
#include "postproc/report/report_model.h"

namespace gouge {
namespace {

using Json = nlohmann::ordered_json;

bool has_gouge(const std::string& verdict) { return verdict == "gouges" || verdict == "material-left"; }

bool is_clean(const std::string& verdict) { return verdict == "clean" || verdict == "accepted-gouges"; }

std::string job_text(const ComparedJob& job, bool has_same) {
  std::string text = printable("job " + job.name) + ": ";
  if (!job.comparison) {
    std::string verdicts = job.verdict_before;
    if (!job.verdict_after.empty()) verdicts += (verdicts.empty() ? "" : ", then ") + job.verdict_after;
    return text + printable(job.why_not + ": " + verdicts) + "\n";
  }
  text += comparison_verdict(*job.comparison) + ": " + change_counts(*job.comparison) + "\n";
  for (const ComparedFinding& one : job.comparison->findings) {
    if (one.change == Change::same && !has_same) continue;
    text += printable("  " + place_of(*job.comparison, one) + ": " + change_text(*job.comparison, one)) + "\n";
  }
  for (const std::string& note : comparison_notes(*job.comparison)) text += printable("  note: " + note) + "\n";
  return text;
}

const char* key_of(JobChange change) { return std::ranges::find(kJobChanges, change, &JobChangeWords::change)->key; }

}  // namespace

ExitCode ComparedJob::exit_status() const {
  if (comparison) return comparison->exit_status();
  if (is_clean(verdict_after)) return kExitClean;
  return has_gouge(verdict_after) && !has_gouge(verdict_before) ? kExitGouges : kExitNotChecked;
}

ExitCode BatchComparison::exit_status() const {
  const auto has = [&](ExitCode status) {
    return std::ranges::any_of(jobs, [&](const ComparedJob& job) { return job.exit_status() == status; });
  };
  return has(kExitGouges) ? kExitGouges : has(kExitNotChecked) ? kExitNotChecked : kExitClean;
}

JobChange ComparedJob::change() const {
  if (exit_status() == kExitGouges) return JobChange::worse;
  if (!comparison) {
    if (verdict_after.empty()) return JobChange::only_before;
    return verdict_before.empty() ? JobChange::only_after : JobChange::not_compared;
  }
  if (exit_status() != kExitClean) return JobChange::open;
  const bool is_better = comparison->count(Change::gone) + comparison->count(Change::shallower) > 0;
  return is_better ? JobChange::better : JobChange::same;
}

std::string BatchComparison::counts() const {
  std::string text = count_text(jobs.size(), "job") + ":";
  for (const JobChangeWords& words : kJobChanges) {
    const auto count = std::ranges::count(jobs, words.change, &ComparedJob::change);
    if (count == 0 && words.change != JobChange::worse) continue;
    text += (text.ends_with(':') ? " " : ", ") + std::to_string(count) + " " + words.text;
  }
  return text;
}

std::string comparison_text(const BatchComparison& batches, bool has_same) {
  std::string text;
  for (const ComparedJob& job : batches.jobs) text += job_text(job, has_same);
  return text + printable(batches.before + " -> " + batches.after) + "\n" + batches.counts() + "\n";
}

std::string comparison_json(const BatchComparison& batches) {
  Json jobs = Json::array();
  for (const ComparedJob& job : batches.jobs) {
    jobs.push_back({{"job", valid_utf8(job.name)},
                    {"change", key_of(job.change())},
                    {"exit_status", static_cast<int>(job.exit_status())},
                    {"verdict_before", job.verdict_before},
                    {"verdict_after", job.verdict_after},
                    {"why_not", valid_utf8(job.why_not)},
                    {"comparison", job.comparison ? comparison_object(*job.comparison) : Json(nullptr)}});
  }
  const Json json = {{"format", "gougecheck-batch-comparison"},
                     {"format_version", 1},
                     {"program", {{"name", kProgramName}, {"version", kProgramVersion}}},
                     {"exit_status", static_cast<int>(batches.exit_status())},
                     {"before", valid_utf8(batches.before)},
                     {"after", valid_utf8(batches.after)},
                     {"jobs", std::move(jobs)}};
  return json.dump(1) + "\n";
}

}  // namespace gouge

#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "postproc/compare/compare_results.h"

namespace gouge {

/// Class of a job of two batches, the worst first.
enum class JobChange { worse, open, not_compared, only_before, only_after, better, same };

/// Words for a class of jobs.
struct JobChangeWords {
  JobChange change;
  const char* title;  ///< "Only in the old batch"
  const char* text;   ///< the same within a sentence
  const char* key;    ///< in JSON: "only-before"
};
inline constexpr std::array kJobChanges{
    JobChangeWords{JobChange::worse, "Worse", "worse", "worse"},
    JobChangeWords{JobChange::open, "Not fully checked", "not fully checked", "not-fully-checked"},
    JobChangeWords{JobChange::not_compared, "Not compared", "not compared", "not-compared"},
    JobChangeWords{JobChange::only_before, "Only in the old batch", "only in the old batch", "only-before"},
    JobChangeWords{JobChange::only_after, "Only in the new batch", "only in the new batch", "only-after"},
    JobChangeWords{JobChange::better, "Better", "better", "better"},
    JobChangeWords{JobChange::same, "Same", "same", "same"}};

/// A job of two batches. Both results are needed for a comparison of findings. Without them the verdicts are compared.
struct ComparedJob {
  std::string name;
  std::string verdict_before, verdict_after;          ///< by the summaries of the batches; empty: no such job
  std::unique_ptr<const StoredResult> before, after;  ///< null: the batch has no result of the job
  std::optional<Comparison> comparison;
  std::string why_not;  ///< why there is no comparison
  /// pages of both reports, as links of the page of the comparison; empty: there is none
  std::string report_before = {}, report_after = {};

  /// That of the comparison. Without one it is that of the verdicts: 0 if the new one is clean, 1 if it gouges and the old
  /// one did not. Else it is 4, because nothing is known of the findings.
  [[nodiscard]] ExitCode exit_status() const;
  /// A worse job is worse whether or not it is in both batches.
  [[nodiscard]] JobChange change() const;
};

struct BatchComparison {
  std::string before, after;  ///< folders of the batches
  std::vector<ComparedJob> jobs;
  std::string page_before = {}, page_after = {};  ///< pages of both batches, as report_before

  /// That of the worst job, in the order 1, 4, 0.
  [[nodiscard]] ExitCode exit_status() const;
  /// Returns "5 jobs: 1 worse, 2 not fully checked, 2 same".
  [[nodiscard]] std::string counts() const;
};

/// Returns the findings of each job that differ, a line for each job, and a summary. Unchanged findings are listed only
/// if `has_same`.
[[nodiscard]] std::string comparison_text(const BatchComparison& batches, bool has_same);
/// Returns the comparisons of all jobs as JSON: docs/formats/compare.md.
[[nodiscard]] std::string comparison_json(const BatchComparison& batches);
/// Returns one page with a row for each job, the worst first. It links to the pages of the reports and needs no other file.
[[nodiscard]] std::string comparison_html(const BatchComparison& batches);

}  // namespace gouge

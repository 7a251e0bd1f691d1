#include "cli/commands/compare_batches.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <ostream>
#include <utility>
#include <vector>

#include "cli/commands/batch_results.h"
#include "cli/output/output_file.h"
#include "cli/output/report_folder.h"
#include "lib/base/exit_code.h"
#include "postproc/compare/batch_comparison.h"

namespace gouge {
namespace {

using ListedJobs = std::vector<ListedJob>;

const ListedJob* find_job(const ListedJobs& jobs, const std::string& name) {
  const auto found = std::ranges::find(jobs, name, &ListedJob::name);
  return found == jobs.end() ? nullptr : &*found;
}

/// Returns the result of a job; null if it has none.
Result<std::unique_ptr<const StoredResult>> load(const ListedJob* job, const InputLimit& limit) {
  if (job == nullptr || job->result_file.empty()) return std::unique_ptr<const StoredResult>();
  Result<StoredResult> result = load_job_result(*job, limit);
  if (!result) return result.error();
  return std::make_unique<const StoredResult>(std::move(*result));
}

std::string why_not(const ListedJob* before, const ListedJob* after) {
  if (after == nullptr) return "the new batch has no such job";
  if (after->result_file.empty()) return "the new batch has no report of it";
  return before == nullptr ? "the old batch has no such job" : "the old batch has no report of it";
}

/// Returns a file as a link of the page `html_file`, relative to its folder or, for standard output, to the present one.
std::string link_from(const std::string& html_file, const std::string& file) {
  namespace fs = std::filesystem;
  const bool is_stdout = html_file.empty() || html_file == "-";
  const fs::path folder =
      is_stdout ? fs::path(canonical_place(".")) : fs::path(canonical_place(html_file)).parent_path();
  return fs::path(canonical_place(file)).lexically_relative(folder).string();
}

/// Adds the links to the pages that both batches have.
void add_links(BatchComparison& batches, const ListedJobs& before, const ListedJobs& after,
               const std::string& html_file) {
  const auto link_to = [&](const std::string& file) {
    std::error_code ignored;
    return std::filesystem::exists(file, ignored) ? link_from(html_file, file) : std::string();
  };
  const auto report_of = [&](const ListedJobs& jobs, const std::string& name) {
    const ListedJob* const job = find_job(jobs, name);
    return job == nullptr || job->report_file.empty() ? std::string() : link_to(job->report_file);
  };
  batches.page_before = link_to((std::filesystem::path(batches.before) / kBatchPageName).string());
  batches.page_after = link_to((std::filesystem::path(batches.after) / kBatchPageName).string());
  for (ComparedJob& job : batches.jobs) {
    job.report_before = report_of(before, job.name);
    job.report_after = report_of(after, job.name);
  }
}

Result<ComparedJob> compare_job(const std::string& name, const ListedJobs& before, const ListedJobs& after,
                                double same_within_mm, const InputLimit& limit) {
  const ListedJob *const old_job = find_job(before, name), *const new_job = find_job(after, name);
  ComparedJob job;
  job.name = name;
  if (old_job != nullptr) job.verdict_before = old_job->verdict;
  if (new_job != nullptr) job.verdict_after = new_job->verdict;
  auto old_result = load(old_job, limit);
  if (!old_result) return old_result.error();
  auto new_result = load(new_job, limit);
  if (!new_result) return new_result.error();
  job.before = std::move(*old_result);
  job.after = std::move(*new_result);
  if (job.before && job.after) {
    job.comparison = compare_results(*job.before, *job.after, {same_within_mm});
  } else {
    job.why_not = why_not(old_job, new_job);
  }
  return job;
}

/// Returns the names of all jobs: first those of the new batch, in its order.
std::vector<std::string> names_of(const ListedJobs& before, const ListedJobs& after) {
  std::vector<std::string> names;
  for (const ListedJob& job : after) names.push_back(job.name);
  for (const ListedJob& job : before)
    if (find_job(after, job.name) == nullptr) names.push_back(job.name);
  return names;
}

std::vector<InputOption> results_of(const ListedJobs& before, const ListedJobs& after) {
  std::vector<InputOption> results;
  for (const ListedJobs* jobs : {&before, &after})
    for (const ListedJob& job : *jobs)
      if (!job.result_file.empty()) results.push_back({"the result of job " + job.name, job.result_file});
  return results;
}

Result<BatchComparison> compare_jobs(const ListedJobs& before, const ListedJobs& after,
                                     const CompareArguments& arguments, double same_within_mm) {
  BatchComparison batches{arguments.before, arguments.after, {}, {}, {}};
  for (const std::string& name : names_of(before, after)) {
    Result<ComparedJob> job = compare_job(name, before, after, same_within_mm, arguments.input);
    if (!job) return job.error();
    batches.jobs.push_back(std::move(*job));
  }
  if (!arguments.html_file.empty()) add_links(batches, before, after, arguments.html_file);
  return batches;
}

}  // namespace

int run_compare_batches(const CompareArguments& arguments, double same_within_mm, std::ostream& out,
                        std::ostream& err) {
  const OutputTable outputs = asked_for({{"--html", arguments.html_file}, {"--json", arguments.json_file}});
  const Result<bool> taken = is_stdout_taken(outputs);
  const Result<ListedJobs> before = read_batch_jobs(arguments.before, arguments.input);
  if (!before) return fail(err, {before.error()});
  const Result<ListedJobs> after = read_batch_jobs(arguments.after, arguments.input);
  if (!after) return fail(err, {after.error()});
  if (const auto status = refuse_outputs(results_of(*before, *after), outputs, err)) return *status;
  const Result<BatchComparison> batches = compare_jobs(*before, *after, arguments, same_within_mm);
  if (!batches) return fail(err, {batches.error()});
  const Outcome written = write_comparison(
      arguments, [&] { return comparison_html(*batches); }, [&] { return comparison_json(*batches); }, out);
  if (!written) return fail(err, {written.error()}, kExitInternal);
  if (!arguments.is_quiet && !*taken) out << comparison_text(*batches, arguments.is_verbose);
  return batches->exit_status();
}

}  // namespace gouge

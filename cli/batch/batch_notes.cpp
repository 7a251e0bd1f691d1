#include "cli/batch/batch_notes.h"

#include <algorithm>
#include <filesystem>
#include <ostream>
#include <set>
#include <sstream>

#include "cli/output/overwriting.h"
#include "cli/terminal/print_diagnostics.h"
#include "lib/base/input_file.h"
#include "lib/base/number_text.h"
#include "lib/base/printable_text.h"

namespace gouge {
namespace {

namespace fs = std::filesystem;

}  // namespace

void note_left_baseline(const std::vector<BatchJob>& jobs, const std::string& list, std::ostream& err) {
  const auto count = std::ranges::count_if(jobs, &BatchJob::leaves_baseline);
  if (count == 0) return;
  print(err, {make_note("jobs-baseline",
                        "\"baseline\" of the defaults does not hold for " +
                            count_text(static_cast<std::size_t>(count), "job") + " with the command correct",
                        list)});
}

void note_replaced(ResultStore& store, const BatchIdentity& identity, const std::string& folder, std::ostream& err) {
  const std::set<std::string> names(identity.names.begin(), identity.names.end());
  const auto replaced =
      std::ranges::count_if(store.stored(), [&](const StoredJob& job) { return !names.contains(job.name); });
  if (replaced == 0) return;
  print(err, {make_note("batch-replaced",
                        "holds the results of " + count_text(static_cast<std::size_t>(replaced), "other job") +
                            ", which this batch replaces",
                        folder)});
}

void note_running(const std::vector<std::string>& names, const std::string& folder, std::ostream& err) {
  constexpr std::size_t kMaxNames = 8;
  if (names.empty()) return;
  const std::size_t shown = std::min(names.size(), kMaxNames);
  std::string text = listed({names.begin(), names.begin() + static_cast<std::ptrdiff_t>(shown)}, " and ");
  if (names.size() > shown) text += " and " + std::to_string(names.size() - shown) + " more";
  print(err,
        {make_note("jobs-running",
                   "an earlier run ended while it ran " + text +
                       "; they run last, so that a job which ends the program does not keep the others from running",
                   folder)});
}

void print_for_job(std::ostream& err, const std::string& job, const std::string& messages) {
  std::istringstream lines(messages);
  for (std::string line; std::getline(lines, line);) err << "job " << printable(job) << ": " << line << "\n";
}

namespace {

// Returns the errors of a job's input files that do not exist, or are folders, each file once.
Diagnostics find_missing_inputs(const BatchJob& job) {
  Diagnostics missing;
  if (job.refusal) missing.push_back(*job.refusal);
  std::set<std::string> seen;
  for (const InputOption& input : inputs_of(job.job())) {
    if (input.file.empty() || input.file == "-" || !seen.insert(input.file).second) continue;
    std::error_code failed;
    const fs::file_status status = fs::status(input.file, failed);
    if (fs::exists(status) && !fs::is_directory(status)) continue;  // opens no pipe, which can be read only once
    if (const auto opened = InputReader::open(input.file, kMaxInputBytes); !opened) missing.push_back(opened.error());
  }
  return missing;
}

}  // namespace

bool list_jobs_and_missing(const std::vector<const BatchJob*>& jobs, std::ostream& out, std::ostream& err) {
  for (const BatchJob* job : jobs) {
    out << printable(job->name) << ": " << job->command();
    for (const std::string& word : job->words) out << ' ' << printable(word);
    out << '\n';
  }
  out.flush();
  bool is_any_missing = false;
  for (const BatchJob* job : jobs) {
    for (const Diagnostic& error : find_missing_inputs(*job)) {
      print_for_job(err, job->name, to_text(error));
      is_any_missing = true;
    }
  }
  return is_any_missing;
}

}  // namespace gouge

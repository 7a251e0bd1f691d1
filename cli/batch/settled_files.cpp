#include "cli/batch/settled_files.h"

#include <fnmatch.h>
#include <sys/stat.h>
#include <unistd.h>
#include <algorithm>
#include <filesystem>
#include <map>
#include <ostream>
#include <string_view>
#include <utility>

#include "cli/batch/batch_job.h"
#include "cli/batch/batch_notes.h"
#include "cli/terminal/terminal.h"
#include "lib/base/exit_code.h"
#include "lib/base/number_text.h"
#include "lib/base/printable_text.h"
#include "postproc/batch/batch_page.h"
#include "postproc/batch/batch_text.h"
#include "postproc/batch/write_summary.h"

namespace gouge {

namespace {

namespace fs = std::filesystem;

constexpr double kSettled_s = 1;

FileStamp stamp_of(const struct stat& file) {
  return {file.st_mtim.tv_sec * std::int64_t{1'000'000'000} + file.st_mtim.tv_nsec, file.st_size};
}

bool is_passed_over(const std::string& name) {
  constexpr std::string_view kTemporary[] = {"~", ".tmp", ".part", ".partial", ".crdownload", ".swp", ".lock"};
  return name.starts_with('.') ||
         std::ranges::any_of(kTemporary, [&](std::string_view end) { return std::string_view(name).ends_with(end); });
}

}  // namespace

SettledFiles::SettledFiles(const std::string& place, std::string output)
    : folder_(place), pattern_("*"), output_(std::move(output)) {
  std::error_code ignored;
  is_whole_folder_ = fs::is_directory(place, ignored);
  if (is_whole_folder_) return;
  folder_ = fs::path(place).has_parent_path() ? fs::path(place).parent_path().string() : ".";
  pattern_ = fs::path(place).filename().string();
}

FileStamps SettledFiles::look(double now_s) {
  found_ = is_whole_folder_ ? folders_in(folder_, output_) : FoldersFound{{folder_}, {}};
  std::map<std::string, Seen> now;
  FileStamps settled;
  for (const std::string& folder : found_.folders) look_into(folder, now_s, now, settled);
  seen_ = std::move(now);
  is_unsettled_ = settled.size() < seen_.size();
  return settled;
}

void SettledFiles::look_into(const std::string& folder, double now_s, std::map<std::string, Seen>& now,
                             FileStamps& settled) const {
  std::error_code ignored;
  for (fs::directory_iterator entry(folder, ignored), end; entry != end; entry.increment(ignored)) {
    const std::string path = entry->path().string(), name = entry->path().filename().string();
    if (is_passed_over(name) || ::fnmatch(pattern_.c_str(), name.c_str(), 0) != 0) continue;
    struct stat file {};
    // A link that leads nowhere is no less settled than a file: its job fails, and so it is not overlooked.
    const bool leads_nowhere = ::stat(path.c_str(), &file) != 0 && entry->is_symlink(ignored);
    if (!leads_nowhere && !S_ISREG(file.st_mode)) continue;
    const FileStamp stamp = stamp_of(file);
    const auto before = seen_.find(path);
    const double since_s = before != seen_.end() && before->second.stamp == stamp ? before->second.since_s : now_s;
    now[path] = {stamp, since_s};
    if (now_s - since_s >= kSettled_s) settled[path] = stamp;
  }
}

SettledInputs::SettledInputs(std::vector<std::string> files, double now_s)
    : files_(std::move(files)), seen_(stamps()), settled_(seen_), since_s_(now_s) {}

FileStamps SettledInputs::look(double now_s) {
  FileStamps now = stamps();
  if (now != seen_) since_s_ = now_s;
  seen_ = std::move(now);
  if (now_s - since_s_ >= kSettled_s) settled_ = seen_;
  return settled_;
}

FileStamps SettledInputs::stamps() const {
  FileStamps stamps;
  for (const std::string& name : files_) {
    struct stat file {};
    if (::stat(name.c_str(), &file) == 0) stamps[name] = stamp_of(file);
  }
  return stamps;
}

Outcome write_batch_files(ReportFolder& folder, const std::vector<JobResult>& results, const SignOff& sign_off) {
  const Outcome staged = folder.stage({{kBatchPageName, write_batch_page(results, sign_off), ""},
                                       {"summary.csv", write_summary_csv(results), ""},
                                       {kBatchSummaryName, write_summary_json(results), ""},
                                       {"junit.xml", write_batch_junit(results), ""},
                                       {"findings.sarif", write_batch_sarif(results), ""}});
  return staged ? folder.commit() : staged;
}

std::optional<Diagnostic> find_foreign_output(const std::vector<std::string>& files, const std::string& folder,
                                              const ResultStore& store) {
  if (store.is_interrupted()) return std::nullopt;
  std::map<std::string, JobOutput> known;
  for (const StoredJob& job : store.stored()) {
    for (const JobOutput& output : job.outputs) known[output.file] = output;
  }
  std::error_code ignored;
  for (const std::string& file : files) {
    if (!fs::exists(fs::symlink_status(folder + "/" + file, ignored))) continue;
    const auto its = known.find(file);
    if (its != known.end() && are_as_written({its->second}, folder)) continue;
    return make_error(
        "report-foreign",
        "would replace " + printable(file) +
            ", which was not written by a batch, or was changed since; expected a folder without this file: name "
            "another folder, move the file away, or give --force to replace it",
        folder);
  }
  return std::nullopt;
}

void print_batch(std::ostream& out, const std::vector<JobResult>& results) {
  constexpr std::size_t kMaxRows = 50;
  out << batch_text(results, is_terminal(out) ? kMaxRows : results.size(), terminal_columns(out));
}

namespace {

// Prints the messages of a job without a result, apart from the first one, which is below the table.
void print_further_messages(std::ostream& err, const JobResult& job) {
  const std::vector<std::string> remarks = job.remarks();
  for (std::size_t k = 1; k < remarks.size(); ++k)
    err << "job " << printable(job.name) << ": " << printable(remarks[k]) << "\n";
}

}  // namespace

void print_job_notes(std::ostream& out, std::ostream& err, const std::vector<JobResult>& results, bool is_verbose) {
  std::size_t count = 0;
  for (const JobResult& job : results) {
    if (!job.unit.empty()) count += job.warnings().size();
    if (!is_verbose) continue;
    for (const Diagnostic& note : job.notes) err << "job " << printable(job.name) << ": " << to_text(note) << "\n";
    if (job.unit.empty()) print_further_messages(err, job);
  }
  if (count > 0 && !is_verbose) out << count_text(count, "warning") << "; -v lists them\n";
}

void print_failures(std::ostream& err, const std::vector<JobResult>& results) {
  for (const JobResult& job : results) {
    if (!job.status || (*job.status != kExitUsage && *job.status != kExitInput && *job.status != kExitInternal))
      continue;
    if (job.messages.empty())
      err << "gougecheck: error: job " << printable(job.name) << " ended with status " << *job.status << "\n";
    print_for_job(err, job.name, job.messages);
  }
}

}  // namespace gouge

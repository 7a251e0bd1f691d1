#include "cli/batch/batch_job.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <exception>
#include <filesystem>
#include <fstream>
#include <new>
#include <set>
#include <sstream>

#include "cli/commands/correct_command.h"
#include "cli/output/overwriting.h"
#include "cli/output/report_folder.h"
#include "cli/terminal/print_diagnostics.h"
#include "lib/base/exit_code.h"
#include "lib/base/printable_text.h"
#include "lib/base/sha256.h"
#include "postproc/store/work_store.h"

namespace gouge {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kWorkEnding = ".work";
constexpr std::size_t kHashDigits = 64;  // length of a SHA-256

std::string host_name() {
  std::array<char, 256> name{};
  return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

std::string at(const std::string& folder, const std::string& file) {
  return file.starts_with('/') ? file : folder + "/" + file;
}

Result<ManifestEntry> describe(const fs::path& file) {
  return describe_file(file.has_parent_path() ? file.parent_path().string() : ".", file.filename().string());
}

using Checksums = std::set<std::pair<std::string, std::string>>;

// Returns the SHA-256 of `text`, of the files with their checksums, and of the searches. Each file and each search counts
// once, as two options may name the same file.
std::string key_of(const std::string& text, const Checksums& files, const std::set<DoneSearch>& searches) {
  Sha256 hash;
  hash.add(text);
  for (const auto& [name, checksum] : files) hash.add(name + '\0' + checksum + '\n');
  for (const auto& [search, found] : searches) {
    hash.add(std::string(rule_name(search.rule)) + '\0' + search.folder + '\0' + search.name + '\n');
    for (const std::string& file : found) hash.add(file + '\0');
    hash.add("\n");
  }
  return hash.finish();
}

Checksums checksums_of(const std::vector<InputFile>& inputs) {
  Checksums files;
  for (const InputFile& input : inputs) files.emplace(input.name, input.checksum);
  return files;
}

/// Lists the outputs of a job that has ended, with the hashes of their present content.
class OutputLister {
 public:
  OutputLister(const BatchJob& job, const std::string& folder) : job_(job), folder_(folder) {}

  // Returns nothing if an output cannot be read. Then the result must not be used again.
  std::optional<std::vector<JobOutput>> run() {
    for (const Output& output : outputs_of(job_.job(), job_.output())) {
      if (output.file.empty()) continue;
      if (output.kind == Output::Kind::report_folder) {
        for (const std::string& name : names_of_report()) add_if_there(output.file + "/" + name);
      } else {
        add(output.file);
      }
    }
    return is_whole_ ? std::optional(std::move(outputs_)) : std::nullopt;
  }

 private:
  void add_if_there(const std::string& file) {
    std::error_code ignored;
    if (fs::exists(file, ignored)) add(file);
  }

  void add(const std::string& file) {
    const fs::path path(file);
    std::error_code ignored;
    // Outputs to a pipe or a device cannot be read again.
    const Result<ManifestEntry> entry =
        fs::is_regular_file(path, ignored) ? describe(path) : make_error("file-unreadable", "is no plain file", file);
    if (!entry) {
      is_whole_ = false;
      return;
    }
    const std::string below = folder_ + "/";
    const bool is_below = file.starts_with(below);
    outputs_.push_back(
        {is_below ? file.substr(below.size()) : fs::absolute(path).string(), entry->bytes, entry->sha256});
  }

  const BatchJob& job_;
  const std::string& folder_;
  std::vector<JobOutput> outputs_;
  bool is_whole_ = true;
};

int run_command(const BatchJob& job, const JobContext& context) {
  if (job.refusal) return fail(context.err, {*job.refusal});
  try {
    if (const auto* check = std::get_if<CheckArguments>(&job.arguments)) return run_check(*check, context);
    return run_correct(std::get<CorrectArguments>(job.arguments), context);
  } catch (const std::bad_alloc&) {
    context.err << "error: out of memory [out-of-memory]\n";
  } catch (const std::exception& failure) {
    context.err << "error: internal failure: " << printable(failure.what()) << " [internal]\n";
  }
  return kExitInternal;
}

}  // namespace

std::string FileHashes::of(const std::string& file) {
  {
    const std::scoped_lock lock(guard_);
    if (const auto found = known_.find(file); found != known_.end()) return found->second;
  }
  const fs::path path(file);
  std::error_code ignored;
  std::string hash;
  if (fs::is_regular_file(path, ignored)) {
    const Result<ManifestEntry> entry = describe(path);
    if (entry) hash = "sha256:" + entry->sha256;
  }
  const std::scoped_lock lock(guard_);
  return known_.try_emplace(file, hash).first->second;
}

std::vector<std::string> FileHashes::found_by(const FileSearch& search) {
  const std::scoped_lock lock(guard_);
  const auto [known, is_new] = searches_.try_emplace(search);
  if (is_new) known->second = repeat_search(search);
  return known->second;
}

std::string job_text(const BatchJob& job, const std::string& program) {
  std::string text = program + '\n' + job.name + '\n' + job.command() + (job.has_report ? " with report" : "") +
                     (job.has_own_certificate ? " with certificate" : "") + '\n';
  for (const std::string& word : job.words) text += word + '\0';
  return text;
}

std::string job_key(const BatchJob& job, const std::string& text, const SearchLog& searches, FileHashes& hashes) {
  std::set<std::string> names;
  for (const InputOption& input : inputs_of(job.job()))
    if (!input.file.empty()) names.insert(input.file);
  std::set<DoneSearch> now;
  for (const DoneSearch& done : searches) {
    std::vector<std::string> found = hashes.found_by(done.search);
    names.insert(found.begin(), found.end());
    now.insert({done.search, std::move(found)});
  }
  Checksums files;
  for (const std::string& name : names) {
    std::string hash = hashes.of(name);
    if (hash.empty()) return {};
    files.emplace(name, std::move(hash));
  }
  return key_of(text, files, now);
}

bool are_as_written(const std::vector<JobOutput>& outputs, const std::string& folder) {
  return std::ranges::all_of(outputs, [&](const JobOutput& output) {
    const fs::path path(at(folder, output.file));
    std::error_code ignored;
    if (!fs::is_regular_file(path, ignored) || fs::file_size(path, ignored) != output.bytes) return false;
    const Result<ManifestEntry> entry = describe(path);
    return entry && entry->sha256 == output.sha256;
  });
}

bool is_below(const std::string& file) {
  const fs::path path(file);
  return !file.empty() && path.is_relative() &&
         std::ranges::none_of(path, [](const fs::path& step) { return step == ".." || step == "."; });
}

JobRun run_job(const BatchJob& job, const std::string& text, const std::string& folder, std::size_t chunk,
               SceneStore& scenes) {
  const auto began = std::chrono::steady_clock::now();
  JobRun run;
  JobResult& result = run.result;
  result.name = job.name;
  result.command = job.command();
  result.toolpath = job.refusal ? printable(job.job().path) : job.job().path;
  std::ostringstream out, err;
  std::string work_file;
  std::optional<WorkStore> work;
  // The name of the work file is a hash of the content that the job has read, which the files may no longer have.
  const auto checkpoints_of = [&](const std::vector<InputFile>& inputs) -> CheckpointStore* {
    work_file = folder + "/" + kWorkFolder + "/" + key_of(text, checksums_of(inputs), {}) + std::string(kWorkEnding);
    return &work.emplace(work_file, chunk);
  };
  const JobContext context{out,
                           err,
                           scenes.source(job.job()),
                           [&](const ReportModel& model) { take_report(model, result); },
                           [&](const SearchLog& searches) { result.searches = searches; },
                           checkpoints_of};
  std::error_code ignored;
  for (const fs::path output : {job.output(), job.has_own_certificate ? job.job().certificate_file : std::string()})
    if (output.has_parent_path()) fs::create_directories(output.parent_path(), ignored);
  result.status = run_command(job, context);
  result.messages = err.str();
  const std::string page = std::string(kReportsFolder) + "/" + job.name + "/report.html";
  if (!result.unit.empty()) {
    if (job.has_report) result.report = page;
    if (auto outputs = OutputLister(job, folder).run()) {
      result.outputs = std::move(*outputs);
      result.key = key_of(text, checksums_of(result.inputs), {result.searches.begin(), result.searches.end()});
    }
  } else if (job.refusal) {
    FileHashes hashes;
    result.key = job_key(job, text, {}, hashes);
  } else if (job.has_report && fs::exists(fs::path(folder) / page, ignored)) {
    result.messages +=
        to_text(make_note("report-old", "is of an earlier run, in which the job did not fail", page)) + "\n";
  }
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  result.memory_mb = static_cast<double>(peak_memory_bytes().value_or(0) / 1'000'000);
  result.host = host_name();
  if (work && work->is_used() && result.status != kExitInternal) run.work_file = work_file;
  return run;
}

void remove_work(const std::string& folder) {
  const std::string below = folder + "/" + kWorkFolder;
  std::error_code ignored;
  std::vector<std::string> files;
  for (fs::directory_iterator entry(below, ignored), end; entry != end; entry.increment(ignored)) {
    const std::string name = entry->path().filename().string();
    const bool is_own = name.size() == kHashDigits + kWorkEnding.size() && name.ends_with(kWorkEnding) &&
                        name.find_first_not_of("0123456789abcdef") == kHashDigits;
    if (is_own) files.push_back(entry->path().string());
  }
  for (const std::string& file : files) remove_work_store(file);
  ::rmdir(below.c_str());  // has an effect only if it is an empty folder
}

}  // namespace gouge

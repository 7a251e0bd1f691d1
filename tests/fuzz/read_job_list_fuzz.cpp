#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "cli/batch/batch_list.h"
#include "cli/batch/jobs_in_the_way.h"
#include "cli/commands/job_words.h"
#include "tests/fuzz/require.h"

// Job lists in a scratch folder with two toolpaths. No name reaches out of it: slashes and double dots become
// underscores. A list is refused with a message, a line and a code of its own, or its jobs have names of their own that
// cannot lead out of the folder of the batch, and words that mean the same when they are parsed again.

namespace gouge {
namespace {

namespace fs = std::filesystem;
using fuzz::require;

void confine(std::string& text) {
  std::replace(text.begin(), text.end(), '/', '_');
  for (std::size_t at = 0; (at = text.find("..", at)) != std::string::npos;) text.replace(at, 2, "__");
}

void require_documented(const Diagnostic& error) {
  static const std::set<std::string> kCodes = {"jobs-syntax", "jobs-duplicate-key", "jobs-field",
                                               "jobs-option", "json-too-deep",      "json-too-long"};
  require(kCodes.contains(error.code) && !error.message.empty());
}

void require_sound(const BatchJob& job, std::set<std::string>& names) {
  require(!job.name.empty() && job.name.find('/') == std::string::npos && job.name.front() != '.');
  require(names.insert(job.name).second && job.line > 0);
  require(!job.has_report || job.job().report_folder == "out/reports/" + job.name);
  require(job.arguments.index() == 0 || !job.output().empty());
  std::vector<std::string> words = job.words;
  if (job.arguments.index() == 1) words.insert(words.begin(), "--output=somewhere");
  if (words.back().starts_with('-')) words.insert(words.end() - 1, "--");
  const Result<CommandArguments> again = parse_command(job.command(), words);
  require(again.has_value() || std::count(words.begin(), words.end(), "--output=somewhere") > 0);
}

void read_list(const std::string& file) {
  const BatchFolder folder{"out", true};
  const Result<std::vector<BatchJob>> jobs = read_job_list(file, folder);
  if (!jobs) return require_documented(jobs.error());
  require(!jobs->empty());
  std::set<std::string> names;
  for (const BatchJob& job : *jobs) require_sound(job, names);
  const std::optional<Diagnostic> in_the_way = find_jobs_in_the_way(*jobs, folder, file);
  require(!in_the_way || (in_the_way->code == "usage" && !in_the_way->message.empty()));
}

fs::path& scratch() {
  static fs::path folder;
  return folder;
}

}  // namespace
}  // namespace gouge

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  std::string name = (std::filesystem::temp_directory_path() / "gouge_fuzz_XXXXXX").string();
  gouge::fuzz::require(::mkdtemp(name.data()) != nullptr);
  gouge::scratch() = name;
  std::atexit([] { std::filesystem::remove_all(gouge::scratch()); });
  std::filesystem::current_path(gouge::scratch());
  for (const char* path : {"a.apt", "b.apt"}) std::ofstream(path) << "GOTO/0,0,5\n";
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string text(reinterpret_cast<const char*>(data), size);
  gouge::confine(text);
  std::ofstream("jobs.json", std::ios::binary | std::ios::trunc) << text;
  gouge::read_list("jobs.json");
  return 0;
}

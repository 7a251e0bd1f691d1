#include "tests/faults/job.h"

#include <gtest/gtest.h>

#include <fstream>
#include <map>

#include "tests/samples/program.h"
#include "tests/samples/sample_folder.h"

namespace gouge::testing_faults {
namespace {

using testing_samples::SampleFolder;

std::vector<std::string> outputs_of(const std::string& name) {
  if (name == "check")
    return {"--json",   "o.json", "--csv",    "o.csv", "--sarif",  "o.sarif", "--junit",       "o.xml",
            "--export", "o.glb",  "--export", "o.vtp", "--export", "o.ply",   "--certificate", "o.gcp"};
  if (name == "correct") return {"-o", "o.apt", "--csv", "o.csv"};
  return {"--report", "report", "--json", "o.json"};
}

std::map<std::string, long> counts_in(const std::string& file, const std::string& prefix) {
  std::map<std::string, long> counts;
  std::ifstream stream(file);
  std::string kind;
  for (long count = 0; stream >> kind >> count;) counts[prefix + kind] = count;
  return counts;
}

Files without(const Files& files, const Files& others) {
  Files rest;
  for (const auto& [name, bytes] : files)
    if (!others.contains(name)) rest[name] = bytes;
  return rest;
}

// A report of something else, with more pictures than the new one, which must be removed; where there is none, any text.
Files older_outputs(const FaultJob& job) {
  if (job.name == "report") {
    const SampleFolder other = testing_samples::open_sample("pocket");
    const std::vector<std::string> outputs = {"--report", job.folder + "/report", "--json", job.folder + "/o.json"};
    EXPECT_EQ(run_program(other.path, other.arguments("check", other.toolpath(), outputs), {}).exit_status, 1);
    return without(files_of(job.folder), job.inputs);
  }
  Files older;
  for (const auto& [name, bytes] : job.outputs) older[name] = "older\n";
  return older;
}

}  // namespace

void FaultJob::prepare(bool has_older) const {
  Files files = inputs;
  if (has_older) files.insert(older.begin(), older.end());
  put_files(folder, files);
}

FaultJob make_job(const std::string& name) {
  const SampleFolder sample = testing_samples::open_sample("between_rib");
  FaultJob job;
  job.name = name;
  job.folder = sample.path;
  std::vector<std::string> more = {"--threads", "2"};
  for (const std::string& word : outputs_of(name)) more.push_back(word);
  job.arguments = sample.arguments(name == "correct" ? "correct" : "check", sample.toolpath(), more);
  job.inputs = files_of(job.folder);
  job.ending = run_program(job.folder, job.arguments, {});
  EXPECT_TRUE(job.ending.exit_status == 0 || job.ending.exit_status == 1) << job.ending.err;
  job.outputs = without(files_of(job.folder), job.inputs);
  EXPECT_GE(job.outputs.size(), 2U) << name;
  job.prepare(false);
  job.older = older_outputs(job);
  job.prepare(false);
  const std::string counts = job.folder + ".counts";
  const auto count = [&](bool is_early, bool has_older) {
    job.prepare(has_older);
    Misfortune counted;
    counted.is_early = is_early;
    counted.counts_file = counts;
    EXPECT_EQ(run_program(job.folder, job.arguments, counted).exit_status, job.ending.exit_status);
    return counts_in(counts, is_early ? "early " : "");
  };
  job.calls = count(false, false);
  job.calls.merge(count(true, false));
  job.calls_over_older = count(false, true);
  EXPECT_GT(job.calls["memory"], 1000) << "the fault library counts nothing";
  return job;
}

namespace {

/// Whether a file for build servers is complete and states that the run ended without a result.
bool states_failure(const std::string& name, const std::string& bytes) {
  if (name.ends_with(".sarif"))
    return bytes.find("\"executionSuccessful\": false") != std::string::npos && bytes.ends_with("]\n}\n");
  return name.ends_with(".xml") && bytes.find("<error message=\"exit status ") != std::string::npos &&
         bytes.ends_with("</testsuites>\n");
}

}  // namespace

std::vector<std::string> wrong_files(const FaultJob& job, bool has_older, bool may_leave_hidden) {
  std::vector<std::string> wrong;
  const Files found = files_of(job.folder);
  for (const auto& [name, bytes] : job.inputs) {
    const auto at = found.find(name);
    if (at == found.end() || at->second != bytes) wrong.push_back("the input " + name + " is not as it was");
  }
  for (const auto& [name, bytes] : found) {
    if (job.inputs.contains(name)) continue;
    const auto is_of = [&, &file = name, &text = bytes](const Files& files) {
      const auto at = files.find(file);
      return at != files.end() && at->second == text;
    };
    if (is_of(job.outputs) || (has_older && is_of(job.older))) continue;
    if (states_failure(name, bytes)) continue;
    if (name == "report/manifest.json") continue;  // lists the old and the new while they change places
    const bool is_hidden = name.find(".gougecheck") != std::string::npos;
    if (is_hidden && may_leave_hidden) continue;
    wrong.push_back(job.outputs.contains(name) ? name + " is neither old nor new" : name + " was left behind");
  }
  return wrong;
}

std::vector<std::string> wrong_ending(const FaultJob& job, const Ending& ending, bool may_refuse_input) {
  if (ending.signal != 0) return {"signal " + std::to_string(ending.signal) + ": " + ending.err};
  const std::string status = "exit status " + std::to_string(ending.exit_status);
  if (ending.exit_status == job.ending.exit_status) {
    std::vector<std::string> wrong;
    if (ending.out != job.ending.out) wrong.push_back(status + ", but another text: " + ending.out + ending.err);
    const Files found = files_of(job.folder);
    for (const auto& [name, bytes] : job.outputs) {
      const auto at = found.find(name);
      if (at == found.end() || at->second != bytes) wrong.push_back(status + ", but " + name + " is not the new one");
    }
    for (const auto& [name, bytes] : without(without(found, job.inputs), job.outputs))
      wrong.push_back(status + ", but " + name + " is there still");
    return wrong;
  }
  const bool is_failure = ending.exit_status == 5 || (may_refuse_input && ending.exit_status == 3);
  if (!is_failure) return {status + ": " + ending.out + ending.err};
  if (ending.err.find("error: ") == std::string::npos) return {status + " without a message: " + ending.err};
  return {};
}

}  // namespace gouge::testing_faults

#include "cli/batch/jobs_in_the_way.h"

#include <algorithm>
#include <filesystem>
#include <map>

#include "cli/output/output_file.h"
#include "cli/output/overwriting.h"
#include "lib/base/printable_text.h"

namespace gouge {
namespace {

namespace fs = std::filesystem;

/// Finds files that one job writes and that another job, or the batch itself, reads or writes.
class CollisionSearch {
 public:
  CollisionSearch(const std::vector<BatchJob>& jobs, const BatchFolder& folder, const std::string& list)
      : jobs_(jobs), folder_(folder), list_(list) {}

  std::optional<Diagnostic> find() {
    if (!list_.empty()) inputs_.emplace(place(list_), "the job list itself");
    for (const BatchJob& job : jobs_) {
      if (const auto wrong = add_inputs(job)) return wrong;
    }
    for (const BatchJob& job : jobs_) {
      for (const Output& output : outputs_of(job.job(), job.output())) {
        if (output.file.empty()) continue;
        if (const auto wrong = add_output(job, output)) return wrong;
      }
    }
    return std::nullopt;
  }

 private:
  const std::string& place(const std::string& file) {
    std::string& at = known_[file];
    if (at.empty()) at = canonical_place(file);
    return at;
  }

  // Adds the inputs of a job. Two jobs cannot read an input that can be read only once.
  std::optional<Diagnostic> add_inputs(const BatchJob& job) {
    for (const InputOption& input : inputs_of(job.job())) {
      if (input.file.empty()) continue;
      const auto [other, is_new] = inputs_.try_emplace(place(input.file), input.what + " of job " + job.name);
      std::error_code ignored;
      if (is_new || !fs::exists(input.file, ignored) || fs::is_regular_file(input.file, ignored) ||
          fs::is_directory(input.file, ignored))
        continue;
      return make_error("usage", "job " + printable(job.name) + ": " + printable(input.file) + " is " + other->second +
                                     " as well, and no plain file, so it can be read but once; name a file");
    }
    return std::nullopt;
  }

  std::optional<Diagnostic> add_output(const BatchJob& job, const Output& output) {
    const std::string said =
        "job " + printable(job.name) + ": " + output.option + " '" + printable(output.file) + "' is ";
    const bool is_report = output.kind == Output::Kind::report_folder;
    const bool is_ours = is_report || std::ranges::any_of(folder_.own_outputs(job), [&](const std::string& name) {
                           return output.file == folder_.path + "/" + name;
                         });
    const std::string below = place(folder_.path) + "/";
    if (!is_ours && (place(output.file) + "/").starts_with(below))
      return make_error("usage", said + "in the folder of the batch, where it alone writes; name a place outside");
    std::vector<std::string> files = {output.file};
    if (is_report) {
      for (const std::string& name : names_of_report()) files.push_back(output.file + "/" + name);
    }
    for (const std::string& file : files) {
      const auto input = inputs_.find(place(file));
      if (input == inputs_.end()) continue;
      return make_error("usage", said + (is_report ? "where " + file + " stands, " : "") + input->second +
                                     "; name another " + (is_report ? "folder" : "file"));
    }
    const auto [other, is_new] = outputs_.try_emplace(place(output.file), output.option + " of job " + job.name);
    if (!is_new) return make_error("usage", said + other->second + " as well; name another file");
    return std::nullopt;
  }

  const std::vector<BatchJob>& jobs_;
  const BatchFolder& folder_;
  const std::string& list_;
  std::map<std::string, std::string> inputs_, outputs_;  // by canonical place: the description of the file
  std::map<std::string, std::string> known_;
};

}  // namespace

std::optional<Diagnostic> find_jobs_in_the_way(const std::vector<BatchJob>& jobs, const BatchFolder& folder,
                                               const std::string& list) {
  return CollisionSearch(jobs, folder, list).find();
}

}  // namespace gouge

#include "cli/batch/batch_sign_off.h"

#include <algorithm>
#include <iterator>
#include <string>

#include "cli/options/help_text.h"
#include "cli/options/job_options.h"
#include "lib/base/number_text.h"

namespace gouge {
namespace {

constexpr std::size_t kMaxNames = 3;  // maximum number of projects or reviewers that the head names

// Returns a text of the jobs, each value once, in the order of the jobs.
std::string values_of(const std::vector<BatchJob>& jobs, std::string JobArguments::*member) {
  std::vector<std::string> values;
  for (const BatchJob& job : jobs) {
    const std::string& value = job.job().*member;
    if (!value.empty() && std::ranges::find(values, value) == values.end()) values.push_back(value);
  }
  const std::size_t more = values.size() - std::min(values.size(), kMaxNames);
  values.resize(values.size() - more);
  return listed(values) + (more > 0 ? " and " + std::to_string(more) + " more" : "");
}

}  // namespace

SignOff batch_sign_off(const BatchArguments& arguments, const std::vector<BatchJob>& jobs) {
  SignOff sign_off;
  sign_off.project = values_of(jobs, &JobArguments::project);
  sign_off.reviewer = values_of(jobs, &JobArguments::reviewer);
  if (const Result<std::string> date = date_of_report()) sign_off.date = *date;
  std::vector<std::string> words = arguments.watch.empty() ? arguments.files : std::vector<std::string>{};
  if (!arguments.watch.empty()) words = {"--watch", arguments.watch};
  std::ranges::copy_if(arguments.words, std::back_inserter(words), [](const std::string& word) {
    return !word.starts_with("--project=") && !word.starts_with("--reviewer=");  // the head has them already
  });
  // The pages of a batch are the same in any folder, so its name is left open.
  sign_off.command = repeatable_words("batch", words) + " -o FOLDER";
  return sign_off;
}

}  // namespace gouge

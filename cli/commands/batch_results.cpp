#include "cli/commands/batch_results.h"

#include <exception>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "cli/output/report_folder.h"
#include "lib/base/files.h"
#include "lib/json/json_file.h"

namespace gouge {
namespace {

namespace fs = std::filesystem;

}  // namespace

Result<std::vector<ListedJob>> read_batch_jobs(const std::string& folder, const InputLimit& limit) {
  const std::string file = (fs::path(folder) / kBatchSummaryName).string();
  const Result<std::string> bytes = read_file(file, limit.max_bytes);
  if (!bytes) return bytes.error();
  const Result<JsonFile> json = parse_json(file, *bytes, {"result-syntax", "result-syntax", "the summary of a batch"});
  if (!json) return json.error();
  std::vector<ListedJob> jobs;
  try {
    if (json->root.at("format") != "gougecheck-batch") throw std::invalid_argument("another format");
    for (const auto& job : json->root.at("jobs")) {
      ListedJob listed{job.at("job"), job.at("verdict"), {}};
      if (const auto& report = job.at("report"); !report.is_null())
        listed.result_file = result_in((fs::path(folder) / report.get<std::string>()).parent_path().string());
      jobs.push_back(std::move(listed));
    }
  } catch (const std::exception&) {
    return make_error("result-format", "is no summary of a batch; expected the folder of batch -o", file);
  }
  return jobs;
}

std::string describe_no_batch(const std::string& name) {
  std::error_code ignored;
  const fs::path path(name);
  if (!fs::exists(path, ignored)) return "does not exist";
  if (!fs::is_directory(path, ignored)) return "is a file; expected the folder of another batch";
  if (is_interrupted_batch(name)) return kIsInterrupted;
  if (fs::exists(result_in(name), ignored)) return "is the report of one job; expected the folder of another batch";
  return "has neither the results of a batch nor those of a job";
}

}  // namespace gouge

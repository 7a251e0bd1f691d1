#include "cli/batch/batch_files.h"

#include <unistd.h>

#include <filesystem>
#include <map>
#include <ostream>
#include <sstream>

#include "cli/batch/batch_job.h"
#include "lib/base/exit_code.h"
#include "lib/base/printable_text.h"
#include "postproc/batch/batch_page.h"
#include "postproc/batch/batch_text.h"
#include "postproc/batch/write_summary.h"

namespace gouge {
namespace fs = std::filesystem;

Outcome write_batch_files(ReportFolder& folder, const std::vector<JobResult>& results) {
  const Outcome staged = folder.stage({{"index.html", write_batch_page(results), ""},
                                       {"summary.csv", write_summary_csv(results), ""},
                                       {"summary.json", write_summary_json(results), ""},
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
            ", which no batch wrote or which was changed since; expected a folder without it: name another "
            "one, move it away, or let --force replace it",
        folder);
  }
  return std::nullopt;
}

void print_batch(std::ostream& out, const std::vector<JobResult>& results) {
  constexpr std::size_t kMostRows = 50;
  out << batch_text(results, ::isatty(STDOUT_FILENO) == 1 ? kMostRows : results.size());
}

void print_failures(std::ostream& err, const std::vector<JobResult>& results) {
  for (const JobResult& job : results) {
    if (!job.status || (*job.status != kExitUsage && *job.status != kExitInput && *job.status != kExitInternal))
      continue;
    if (job.messages.empty())
      err << "gougecheck: error: job " << printable(job.name) << " ended with status " << *job.status << "\n";
    std::istringstream lines(job.messages);
    for (std::string line; std::getline(lines, line);) err << "job " << printable(job.name) << ": " << line << "\n";
  }
}

}  // namespace gouge

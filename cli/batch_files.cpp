#include "cli/batch_files.h"

#include <unistd.h>

#include <ostream>

#include "postproc/batch/batch_page.h"
#include "postproc/batch/batch_text.h"
#include "postproc/batch/write_summary.h"

namespace gouge {

Outcome write_batch_files(ReportFolder& folder, const std::vector<JobResult>& results) {
  const Outcome staged = folder.stage({{"index.html", write_batch_page(results), ""},
                                       {"summary.csv", write_summary_csv(results), ""},
                                       {"summary.json", write_summary_json(results), ""},
                                       {"junit.xml", write_batch_junit(results), ""},
                                       {"findings.sarif", write_batch_sarif(results), ""}});
  return staged ? folder.commit() : staged;
}

void print_batch(std::ostream& out, const std::vector<JobResult>& results) {
  constexpr std::size_t kMostRows = 50;
  out << batch_text(results, ::isatty(STDOUT_FILENO) == 1 ? kMostRows : results.size());
}

}  // namespace gouge

#include "postproc/batch/batch_text.h"

#include <algorithm>
#include <array>

#include "lib/base/number_text.h"
#include "lib/base/printable_text.h"
#include "postproc/report/report_text.h"

namespace gouge {
namespace {

using TableRow = std::array<std::string, 6>;

// Returns a time with enough digits to compare jobs, but short enough for a line.
std::string time_text(double seconds) { return fixed_text(seconds, seconds < 10 ? 2 : seconds < 100 ? 1 : 0) + " s"; }

TableRow text_row(const JobResult& job) {
  if (!job.status) return {printable(job.name), job.verdict(), "", "", "", ""};
  std::string deepest = deepest_text(job);
  if (job.unit.empty()) {
    const std::vector<std::string> remarks = job.remarks();
    deepest = remarks.empty() ? "status " + std::to_string(*job.status) : remarks.front();
  }
  return {printable(job.name),    job.verdict(),     std::to_string(job.moves()), std::to_string(job.gouge_findings()),
          time_text(job.seconds), printable(deepest)};
}

}  // namespace

std::string deepest_text(const JobResult& job) {
  if (!job.deepest) return {};
  const LengthUnit unit = unit_called(job.unit).value_or(LengthUnit::mm);
  return depth_text(job.deepest_mm, unit) + " at line " + std::to_string(job.deepest_line);
}

std::string batch_text(const std::vector<JobResult>& jobs, std::size_t most) {
  std::vector<TableRow> rows = {{"job", "verdict", "moves", "findings", "time", "deepest"}};
  for (const std::size_t job : worst_first(jobs)) {
    if (rows.size() > most) break;
    rows.push_back(text_row(jobs[job]));
  }
  std::array<std::size_t, 6> widths{};
  for (const TableRow& row : rows) {
    for (std::size_t k = 0; k < row.size(); ++k) widths[k] = std::max(widths[k], display_width(row[k]));
  }
  std::string text;
  for (const TableRow& row : rows) {
    std::string line;
    for (std::size_t k = 0; k < row.size(); ++k) {
      const std::string blanks(widths[k] - display_width(row[k]), ' ');
      const bool is_number = k >= 2 && k <= 4;
      line += (k == 0 ? "" : "  ") + (is_number ? blanks + row[k] : row[k] + blanks);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  if (jobs.size() + 1 > rows.size())
    text += "and " + count_text(jobs.size() + 1 - rows.size(), "more job") + "; summary.csv has them all\n";
  return text + count_text(jobs.size(), "job") + ": " + verdict_counts(jobs) + "\n";
}

}  // namespace gouge

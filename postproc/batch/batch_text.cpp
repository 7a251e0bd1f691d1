#include "postproc/batch/batch_text.h"

#include <algorithm>
#include <array>
#include <string_view>

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
  return {printable(job.name),         job.verdict(),
          std::to_string(job.moves()), std::to_string(job.gouge_findings()),
          time_text(job.seconds),      printable(deepest_text(job))};
}

// Returns "3 moves not checked, 1 move not certified", or nothing. Rapids that were left out have a remark of their own.
std::string open_moves_text(const StateCounts& counts) {
  std::vector<std::string> parts;
  const std::size_t not_checked = counts.not_checked - std::min(counts.skipped, counts.not_checked);
  if (not_checked > 0) parts.push_back(count_text(not_checked, "move") + " not checked");
  if (counts.not_certified > 0) parts.push_back(count_text(counts.not_certified, "move") + " not certified");
  return listed(parts);
}

// Returns the warnings with which even a gouge may be none: the part or the stock seems to lie elsewhere.
std::vector<std::string> misplacements(const JobResult& job) {
  constexpr std::array<std::string_view, 4> kCodes = {"path-unit", "path-setup", "scene-misplaced", "stock-misplaced"};
  std::vector<std::string> texts;
  for (const Diagnostic& warning : job.warnings()) {
    if (std::ranges::find(kCodes, warning.code) != kCodes.end()) texts.push_back(to_text(warning));
  }
  return texts;
}

// Returns what a reader of the table must know of a job: why it failed or is not fully checked, the number of rapids left
// out, or that something seems misplaced.
std::vector<std::string> reasons(const JobResult& job) {
  const bool is_open = job.verdict() == std::string_view("not-fully-checked");
  if (!job.status) return {};
  if (job.unit.empty() || is_open) {
    std::vector<std::string> all = job.remarks();
    if (const std::string moves = open_moves_text(job.counts); is_open && !moves.empty()) all.push_back(moves);
    if (all.empty() && job.unit.empty()) all.push_back("status " + std::to_string(*job.status));
    return all;
  }
  std::vector<std::string> all = misplacements(job);
  if (job.counts.skipped > 0) all.insert(all.begin(), left_out_text(job.counts.skipped));
  return all;
}

// Returns a line with the first reason, and the number of the others; empty: there is none.
std::string reason_line(const JobResult& job) {
  const std::vector<std::string> all = reasons(job);
  if (all.empty()) return {};
  return job.name + ": " + all.front() + (all.size() > 1 ? "; and " + count_text(all.size() - 1, "more remark") : "");
}

}  // namespace

std::string deepest_text(const JobResult& job) {
  if (!job.deepest) return {};
  const LengthUnit unit = unit_called(job.unit).value_or(LengthUnit::mm);
  return depth_text(job.deepest_mm, unit) + " at line " + std::to_string(job.deepest_line);
}

std::string batch_text(const std::vector<JobResult>& jobs, std::size_t most, std::size_t columns) {
  std::vector<TableRow> rows = {{"job", "verdict", "moves", "findings", "time", "deepest"}};
  const std::vector<std::size_t> order = worst_first(jobs);
  for (std::size_t k = 0; k < order.size() && rows.size() <= most; ++k) rows.push_back(text_row(jobs[order[k]]));
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
  for (std::size_t k = 0; k + 1 < rows.size(); ++k) {
    const std::string reason = reason_line(jobs[order[k]]);
    constexpr std::size_t kIndent = 2;
    if (!reason.empty())
      text += (columns > 0 ? wrapped(printable(reason), columns, kIndent) : printable(reason)) + "\n";
  }
  return text + count_text(jobs.size(), "job") + (jobs.empty() ? "" : ": ") + verdict_counts(jobs) + "\n";
}

}  // namespace gouge

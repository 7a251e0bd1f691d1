#include <algorithm>
#include <string_view>
#include <vector>

#include "postproc/compare/batch_comparison.h"
#include "postproc/compare/comparison_page.h"
#include "postproc/compare/write_comparison.h"
#include "postproc/report/html_table.h"
#include "postproc/report/report_text.h"

namespace gouge {
namespace {

/// CSS classes of a class of jobs.
struct JobStyle {
  const char* number;
  const char* state;  ///< of the state of a row
};

JobStyle style_of(JobChange change) {
  switch (change) {
    case JobChange::worse:
      return {"bad", "gouge"};
    case JobChange::open:
    case JobChange::not_compared:
    case JobChange::only_before:
      return {"open", "not-checked"};
    case JobChange::better:
      return {"", "better"};
    case JobChange::only_after:
    case JobChange::same:
      break;
  }
  return {"", ""};
}

// On a phone each job is a block, with the names of its values.
constexpr const char* kBatchComparisonStyle = R"(
.state.better { background: var(--calm); }
td:nth-child(1) { min-width: 14em; } td.n.bad { color: var(--bad); font-weight: 600; }
td.n.open { color: var(--doubt); font-weight: 600; }
@media screen and (min-width: 961px) { th.n, td.n { width: 1%; } }
@media screen and (max-width: 960px) {
  td:nth-child(1), td:nth-child(2) { grid-column: 1 / -1; } .cards tbody td.n:empty, .cards tbody td.none { display: none; }
  td:nth-child(4)::before { content: "New "; } td:nth-child(5)::before { content: "Deeper "; }
  td:nth-child(6)::before { content: "Not checked any more "; } td:nth-child(7)::before { content: "Gone "; }
  td:nth-child(8)::before { content: "Shallower "; } td:nth-child(9)::before { content: "Same "; }
  .cards tbody td:nth-child(3) { grid-column: 1 / -1; }
}
@media print {
  td:nth-child(1) { min-width: 16em; } th.n, td.n { width: 1%; } .state { font-size: 9px; padding: 0 6px; }
  .numbers { gap: 8px; } .numbers div { flex-basis: 60px; padding: 7px 9px; }
}
)";

std::string linked(const std::string& link, const std::string& text) {
  return link.empty() ? xml_escaped(text) : "<a href=\"" + uri_of(link) + "\">" + xml_escaped(text) + "</a>";
}

std::string verdict_of(const std::string& verdict, const std::string& report) {
  return verdict.empty() ? "no such job" : linked(report, verdict);
}

std::string count_cell(const ComparedJob& job, Change change) {
  if (!job.comparison) return "<td class=\"n\"></td>";
  const std::size_t count = job.comparison->count(change);
  const bool is_worse = change == Change::fresh || change == Change::deeper;
  const char* css = count == 0 ? "n none" : is_worse ? "n bad" : change == Change::not_checked ? "n open" : "n";
  return html_cell(std::to_string(count), css);
}

std::string job_cell(const ComparedJob& job) {
  std::string cell = "<td>" + linked(job.report_after.empty() ? job.report_before : job.report_after, job.name);
  if (!job.comparison) return cell + "<div class=\"soft\">" + xml_escaped(job.why_not) + "</div></td>";
  for (const std::string& note : comparison_notes(*job.comparison))
    cell += "<div class=\"soft\">" + xml_escaped(note) + "</div>";
  return cell + "</td>";
}

std::string job_row(const ComparedJob& job, const char* title) {
  std::string row = job_cell(job) + "<td class=\"k\"><span class=\"state " + style_of(job.change()).state + "\">" +
                    title + "</span></td><td>" + verdict_of(job.verdict_before, job.report_before) + ", then " +
                    verdict_of(job.verdict_after, job.report_after) + "</td>";
  for (std::size_t k = 0; k < kChanges; ++k) row += count_cell(job, static_cast<Change>(k));
  return row;
}

std::string jobs_table(const BatchComparison& batches) {
  HtmlTable table({{"Job"},
                   {"Change"},
                   {"Verdict"},
                   {"New", "n"},
                   {"Deeper", "n"},
                   {"Not checked<br>any more", "n"},
                   {"Gone", "n"},
                   {"Shallower", "n"},
                   {"Same", "n"}});
  for (const JobChangeWords& words : kJobChanges) {
    for (const ComparedJob& job : batches.jobs) {
      if (job.change() != words.change) continue;
      table.has_room() ? table.add(job_row(job, words.title)) : table.skip();
    }
  }
  return table.html();
}

std::string job_numbers(const BatchComparison& batches) {
  std::string out = "<div class=\"numbers\">";
  for (const JobChangeWords& words : kJobChanges) {
    const auto count = std::ranges::count(batches.jobs, words.change, &ComparedJob::change);
    out += comparison_number(static_cast<std::size_t>(count), words.title, style_of(words.change).number);
  }
  return out + "</div>\n";
}

}  // namespace

std::string comparison_html(const BatchComparison& batches) {
  return comparison_page_begin("Comparison: " + batches.before + " to " + batches.after, kBatchComparisonStyle) +
         "<p class=\"soft\">Batches " + linked(batches.page_before, batches.before) + ", then " +
         linked(batches.page_after, batches.after) + "</p>\n" +
         comparison_banner(batches.exit_status(), batches.counts()) + job_numbers(batches) + "<h2>Jobs</h2>\n" +
         "<p class=\"soft\">The numbers count findings. Each verdict leads to its report.</p>\n" + jobs_table(batches) +
         comparison_page_end();
}

}  // namespace gouge

#include "postproc/batch/batch_page.h"

#include <algorithm>

#include "lib/base/number_text.h"
#include "postproc/batch/batch_text.h"
#include "postproc/report/html_table.h"
#include "postproc/report/report_sources.h"
#include "postproc/report/report_text.h"

namespace gouge {
namespace {

constexpr const char* kPageStyle = R"css(
th button { font: inherit; color: inherit; background: none; border: 0; padding: 0; cursor: pointer; }
th button:hover { color: var(--link); } th[aria-sort=ascending] button::after { content: " \25B2"; }
th[aria-sort=descending] button::after { content: " \25BC"; }
#filter { font: inherit; width: 100%; max-width: 26em; padding: 6px 10px; border: 1px solid var(--line); border-radius: 5px; }
#shown { margin-left: 14px; } td:nth-child(2) { min-width: 15em; } td.picture { min-width: 0; width: 108px; padding: 4px 12px 4px 0; }
td.picture img { width: 96px; height: 60px; object-fit: cover; border: 1px solid var(--line); border-radius: 3px; display: block; }
.state.gouges, .state.material-left, .state.failed { background: var(--alarm); } .state.clean { background: var(--calm); }
.state.not-fully-checked { background: var(--open); } .banner.failed { background: var(--alarm); }
@media print { #tools { display: none; } }
)css";

// A cell whose text is not its sort key has the key in data-v.
constexpr const char* kScript = R"js(
const table = document.querySelector("table"), body = table.tBodies[0], rows = [...body.rows];
const value = (row, k) => { const c = row.cells[k], v = c.dataset.v ?? c.textContent; return v !== "" && !isNaN(v) ? +v : v; };
[...table.tHead.rows[0].cells].forEach((head, k) => head.querySelector("button")?.addEventListener("click", () => {
  const down = head.getAttribute("aria-sort") === "ascending";
  for (const other of table.tHead.rows[0].cells) other.removeAttribute("aria-sort");
  head.setAttribute("aria-sort", down ? "descending" : "ascending");
  const sorted = [...rows].sort((a, b) => { const x = value(a, k), y = value(b, k);
    const by = typeof x === typeof y ? (x < y ? -1 : x > y ? 1 : 0) : typeof x === "number" ? -1 : 1;
    return down ? -by : by; });
  body.append(...sorted);
}));
const filter = document.getElementById("filter"), shown = document.getElementById("shown");
const apply = () => { const words = filter.value.toLowerCase().split(/\s+/); let count = 0;
  for (const row of rows) { const text = row.textContent.toLowerCase();
    row.hidden = !words.every(word => text.includes(word)); count += row.hidden ? 0 : 1; }
  shown.textContent = count === rows.length ? "" : count + " of " + rows.length + " jobs"; };
filter.addEventListener("input", apply); apply();
)js";

std::string sorted_by(const std::string& value, const std::string& shown, const char* css) {
  return "<td class=\"" + std::string(css) + "\" data-v=\"" + xml_escaped(value) + "\">" + shown + "</td>";
}

std::string picture_cell(const JobResult& job) {
  const std::string folder = job.report.substr(0, job.report.rfind('/') + 1);
  const bool has_picture = !job.report.empty() && std::ranges::any_of(job.outputs, [&](const JobOutput& output) {
    return output.file == folder + "heat_map.png";
  });
  if (!has_picture) return "<td class=\"picture\"></td>";
  return "<td class=\"picture\"><a href=\"" + uri_of(job.report) + "\"><img loading=\"lazy\" alt=\"\" src=\"" +
         uri_of(folder + "heat_map.png") + "\"></a></td>";
}

std::string name_cell(const JobResult& job) {
  const std::string name = xml_escaped(job.name);
  const std::string shown = job.report.empty() ? name : "<a href=\"" + uri_of(job.report) + "\">" + name + "</a>";
  const std::string path = "<div class=\"soft\">" + xml_escaped(job.toolpath) + "</div>";
  return sorted_by(job.name, shown + path, "");
}

std::string remark(const JobResult& job) {
  const std::vector<std::string> all = job.remarks();
  if (all.empty()) return {};
  return all.front() + (all.size() > 1 ? "; and " + std::to_string(all.size() - 1) + " more" : "");
}

std::string page_row(const JobResult& job, std::size_t rank) {
  const std::string verdict = job.verdict();
  const std::string state = "<span class=\"state " + verdict + "\">" + verdict + "</span>";
  std::string row = picture_cell(job) + name_cell(job) + sorted_by(std::to_string(rank), state, "k");
  if (!job.status) return row + "<td></td><td></td><td></td><td></td>";
  row += html_cell(std::to_string(job.moves()), "n") + html_cell(std::to_string(job.gouge_findings()), "n");
  row += sorted_by(job.deepest ? exact_text(job.deepest_mm) : "", xml_escaped(deepest_text(job)), "n");
  return row + html_cell(remark(job));
}

std::string banner(const std::vector<JobResult>& jobs) {
  const bool any_failed = std::ranges::any_of(jobs, [](const JobResult& job) { return severity_of(job.status) < 3; });
  const int status = batch_status(jobs);
  const char* css = any_failed ? "failed" : status == 1 ? "gouges" : status == 0 ? "clean" : "not-fully-checked";
  const bool any_accepted = std::ranges::any_of(
      jobs, [](const JobResult& job) { return job.verdict() == std::string_view("accepted-gouges"); });
  const char* word = any_failed     ? "Jobs failed"
                     : status == 1  ? "Gouges"
                     : status == 4  ? "Not fully checked"
                     : any_accepted ? "Accepted gouges"
                                    : "Clean";
  return std::string("<div class=\"banner ") + css + "\"><strong>" + word + "</strong><div>" +
         xml_escaped(count_text(jobs.size(), "job") + ": " + verdict_counts(jobs)) + "</div></div>\n";
}

std::string numbers(const std::vector<JobResult>& jobs) {
  std::size_t moves = 0, findings = 0, gouging = 0;
  for (const JobResult& job : jobs) {
    moves += job.moves();
    findings += job.gouge_findings();
    gouging += job.counts.gouge + job.counts.buried;
  }
  const auto box = [](const std::string& value, const char* what, const char* css) {
    return std::string("<div class=\"") + css + "\"><b>" + value + "</b><span>" + what + "</span></div>";
  };
  return "<div class=\"numbers\">" + box(std::to_string(jobs.size()), "jobs", "") +
         box(std::to_string(moves), "moves", "") + box(std::to_string(findings), "findings", "") +
         box(std::to_string(gouging), "gouging moves", gouging > 0 ? "bad" : "") + "</div>\n";
}

}  // namespace

std::string write_batch_page(const std::vector<JobResult>& jobs) {
  std::string page =
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
      "content=\"width=device-width, initial-scale=1\">\n<title>Gouge check: batch</title>\n<style>" +
      std::string(kHtmlStyle) + kPageStyle + "</style>\n</head>\n<body>\n<main>\n<h1>Gouge check: batch</h1>\n" +
      banner(jobs) + numbers(jobs) +
      "<h2>Jobs</h2>\n<p id=\"tools\"><input id=\"filter\" type=\"search\" placeholder=\"Filter by words\" "
      "aria-label=\"Filter by words\"><span id=\"shown\" class=\"soft\"></span></p>\n<div class=\"wide\"><table>"
      "<thead><tr><th></th>";
  for (const char* title : {"Job", "Verdict", "Moves", "Findings", "Deepest", "Remark"}) {
    const std::string_view word = title;
    const bool is_number = word == "Moves" || word == "Findings" || word == "Deepest";
    page +=
        std::string(is_number ? "<th class=\"n\">" : "<th>") + "<button type=\"button\">" + title + "</button></th>";
  }
  page += "</tr></thead><tbody>\n";
  std::size_t rank = 0;
  for (const std::size_t job : worst_first(jobs)) page += "<tr>" + page_row(jobs[job], rank++) + "</tr>\n";
  return page + "</tbody></table></div>\n<footer>" + kProgramName + " " + kProgramVersion +
         "</footer>\n</main>\n<script>" + kScript + "</script>\n</body>\n</html>\n";
}

}  // namespace gouge

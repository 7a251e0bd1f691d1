#include "postproc/batch/batch_page.h"

#include <algorithm>

#include "lib/base/number_text.h"
#include "postproc/batch/batch_sources.h"
#include "postproc/batch/batch_text.h"
#include "postproc/report/baseline_text.h"
#include "postproc/report/html_table.h"
#include "postproc/report/report_sources.h"
#include "postproc/report/report_text.h"

namespace gouge {
namespace {

constexpr std::size_t kMaxNames = 4;       // maximum number of files of one role that the head names
constexpr std::size_t kMaxAccepted = 500;  // maximum number of accepted findings that the page lists

std::string sorted_by(const std::string& value, const std::string& shown, const char* css) {
  return "<td class=\"" + std::string(css) + "\" data-v=\"" + xml_escaped(value) + "\">" + shown + "</td>";
}

std::string picture_cell(const JobResult& job) {
  const std::string folder = job.report.substr(0, job.report.rfind('/') + 1);
  const bool has_picture = !job.report.empty() && std::ranges::any_of(job.outputs, [&](const JobOutput& output) {
    return output.file == folder + "heat_map.png";
  });
  if (!has_picture) return "<td class=\"picture\"></td>";
  return "<td class=\"picture\"><a href=\"" + uri_of(job.report) + "\"><img loading=\"lazy\" alt=\"Heat map\" src=\"" +
         uri_of(folder + "heat_map.png") + "\"></a></td>";
}

std::string name_cell(const JobResult& job) {
  const std::string name = xml_escaped(job.name);
  const std::string shown = job.report.empty() ? name : "<a href=\"" + uri_of(job.report) + "\">" + name + "</a>";
  const std::string path = "<div class=\"soft\">" + xml_escaped(job.toolpath) + "</div>";
  return sorted_by(job.name, shown + path, "");
}

std::size_t accepted_findings(const JobResult& job) {
  return static_cast<std::size_t>(std::ranges::count(job.findings, "unchanged", &Finding::baseline_state));
}

// Returns in words that acceptances of another program apply to findings of this job; empty if none does.
std::string acceptance_of_others(const JobResult& job) {
  const auto count = static_cast<std::size_t>(std::ranges::count_if(job.findings, [](const Finding& finding) {
    return finding.justification.find(kThroughEntry) != std::string::npos;
  }));
  return count == 0 ? std::string() : count_text(count, "finding") + " accepted" + kThroughEntry + "another program";
}

std::string remark(const JobResult& job) {
  const std::vector<std::string> all = job.remarks();
  std::string text = acceptance_of_others(job);
  if (all.empty()) return text;
  return text + (text.empty() ? "" : "; ") + all.front() +
         (all.size() > 1 ? "; and " + std::to_string(all.size() - 1) + " more" : "");
}

std::string findings_cell(const JobResult& job) {
  const std::size_t accepted = accepted_findings(job);
  const std::string count = std::to_string(job.gouge_findings());
  return sorted_by(
      count, count + (accepted > 0 ? "<div class=\"soft\">" + std::to_string(accepted) + " accepted</div>" : ""), "n");
}

// Returns the moves that are not checked or not certified, without those that were left out as asked.
std::size_t open_moves(const JobResult& job) {
  return job.counts.not_checked - job.counts.skipped + job.counts.not_certified;
}

std::string moves_cell(const JobResult& job) {
  std::string text = std::to_string(job.moves());
  if (open_moves(job) > 0) text += "<div class=\"soft\">" + std::to_string(open_moves(job)) + " not checked</div>";
  if (job.counts.skipped > 0)
    text += "<div class=\"soft\">" + count_text(job.counts.skipped, "rapid") + " left out</div>";
  return sorted_by(std::to_string(job.moves()), text, "n");
}

// Returns the names of the files with a role, each once, in the order of the jobs.
std::string names_of(const std::vector<JobResult>& jobs, std::string_view role) {
  std::vector<std::string> names;
  for (const JobResult& job : jobs) {
    for (const InputFile& input : job.inputs) {
      if (input.role == role && std::ranges::find(names, input.name) == names.end()) names.push_back(input.name);
    }
  }
  const std::size_t more = names.size() - std::min(names.size(), kMaxNames);
  names.resize(names.size() - more);
  return listed(names) + (more > 0 ? " and " + std::to_string(more) + " more" : "");
}

std::string against(const std::vector<JobResult>& jobs) {
  std::string text;
  for (const char* role : {"part", "fixture", "head", "tools", "baseline"}) {
    const std::string names = names_of(jobs, role);
    if (!names.empty()) text += (text.empty() ? "" : "; ") + std::string(role) + " " + names;
  }
  return text.empty() ? text : "<p class=\"soft\">against " + xml_escaped(text) + "</p>\n";
}

std::string page_row(const JobResult& job, std::size_t rank) {
  const std::string verdict = job.verdict();
  const std::string state = "<span class=\"state " + verdict + "\">" + verdict + "</span>";
  std::string row = picture_cell(job) + name_cell(job) + sorted_by(std::to_string(rank), state, "k");
  if (!job.status) return row + "<td></td><td></td><td></td><td></td>";
  row += moves_cell(job) + findings_cell(job);
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
  std::size_t moves = 0, findings = 0, gouging = 0, open = 0;
  for (const JobResult& job : jobs) {
    moves += job.moves();
    findings += job.gouge_findings();
    gouging += job.counts.gouge + job.counts.buried;
    open += open_moves(job);
  }
  const auto box = [](const std::string& value, const char* what, const char* css) {
    return std::string("<div class=\"") + css + "\"><b>" + value + "</b><span>" + what + "</span></div>";
  };
  return "<div class=\"numbers\">" + box(std::to_string(jobs.size()), "jobs", "") +
         box(std::to_string(moves), "moves", "") + box(std::to_string(findings), "findings", "") +
         box(std::to_string(gouging), "gouging moves", gouging > 0 ? "bad" : "") +
         (open > 0 ? box(std::to_string(open), "moves not checked", "open") : "") + "</div>\n";
}

// Returns the accepted findings of all jobs, with who accepted each of them and why; empty if there is none.
std::string accepted_list(const std::vector<JobResult>& jobs) {
  std::string items;
  std::size_t count = 0;
  for (const JobResult& job : jobs) {
    for (const Finding& finding : job.findings) {
      if (finding.justification.empty() || ++count > kMaxAccepted) continue;
      items += "<li><b>" + xml_escaped(job.name) + "</b> line " + std::to_string(finding.line) + ": " +
               xml_escaped(finding.message) + "</li>\n";  // the message has name, date and reason
    }
  }
  if (count == 0) return {};
  const std::string rest =
      count > kMaxAccepted ? "<p>and " + std::to_string(count - kMaxAccepted) + " more, in the reports</p>\n" : "";
  return "<h2>Accepted findings</h2>\n<ul class=\"accepted\">\n" + items + "</ul>\n" + rest;
}

}  // namespace

std::string write_batch_page(const std::vector<JobResult>& jobs, const SignOff& sign_off) {
  std::string page =
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
      "content=\"width=device-width, initial-scale=1\">\n<title>Gouge check: batch</title>\n<style>" +
      std::string(kHtmlStyle) + std::string(kBatchStyle) +
      "</style>\n</head>\n<body>\n<main class=\"cards\">\n<h1>Gouge check: batch</h1>\n" + against(jobs) +
      sign_off_facts(sign_off) + banner(jobs) + numbers(jobs) + sign_off_lines(sign_off) +
      "<h2>Jobs</h2>\n<p id=\"tools\"><input id=\"filter\" type=\"search\" placeholder=\"Filter by words\" "
      "aria-label=\"Filter by words\"><span id=\"shown\" class=\"soft\" role=\"status\"></span></p>\n"
      "<div class=\"wide\"><table><thead><tr><th></th>";
  for (const char* title : {"Job", "Verdict", "Moves", "Findings", "Deepest", "Remark"}) {
    const std::string_view word = title;
    const bool is_number = word == "Moves" || word == "Findings" || word == "Deepest";
    page +=
        std::string(is_number ? "<th class=\"n\">" : "<th>") + "<button type=\"button\">" + title + "</button></th>";
  }
  page += "</tr></thead><tbody>\n";
  std::size_t rank = 0;
  for (const std::size_t job : worst_first(jobs)) {
    const std::string report = jobs[job].report.empty() ? "" : " data-report=\"" + uri_of(jobs[job].report) + "\"";
    page +=
        "<tr data-job=\"" + xml_escaped(jobs[job].name) + "\"" + report + ">" + page_row(jobs[job], rank++) + "</tr>\n";
  }
  return page + "</tbody></table></div>\n" + accepted_list(jobs) + "<footer>" + kProgramName + " " + kProgramVersion +
         "</footer>\n</main>\n<script>\n" + std::string(kBatchScript) + "</script>\n</body>\n</html>\n";
}

}  // namespace gouge

#include "postproc/report/sign_off.h"

#include <algorithm>

#include "postproc/report/report_model.h"
#include "postproc/report/report_text.h"

namespace gouge {

std::string batch_links(const SignOff& s) {
  if (s.batch_job.empty()) return {};
  const auto link = [&](const char* way, const char* words) {
    return std::string("<a href=\"../../index.html#") + way + "=" + uri_of(s.batch_job) + "\">" + words + "</a>";
  };
  return "<nav class=\"on-screen\">" + link("at", "All reports of the batch") + link("before", "Previous report") +
         link("after", "Next report") + "</nav>\n";
}

namespace {

/// Returns a command for a page. Lines break before an option, as browsers also break behind its dashes.
std::string command_html(const std::string& command) {
  std::string out;
  for (std::size_t at = 0; at < command.size();) {
    const std::size_t end = std::min(command.find(' ', at), command.size());
    const std::string word = xml_escaped(command.substr(at, end - at));
    out += (at == 0 ? "" : " ") + (word.starts_with('-') ? "<span>" + word + "</span>" : word);
    at = end + 1;
  }
  return out;
}

}  // namespace

std::string sign_off_facts(const SignOff& s) {
  std::string out = "<dl class=\"facts\">\n";
  const auto add = [&](const char* name, const std::string& html, const char* css = "") {
    if (!html.empty()) out += std::string("<div") + css + "><dt>" + name + "</dt><dd>" + html + "</dd></div>\n";
  };
  add("Project", xml_escaped(s.project));
  add("Reviewer", xml_escaped(s.reviewer));
  add("Date", xml_escaped(s.date));
  add("Program", std::string(kProgramName) + " " + kProgramVersion);
  add("Command", command_html(s.command), " class=\"command\"");
  return out + "</dl>\n";
}

std::string sign_off_lines(const SignOff& s) {
  std::string out = "<div class=\"sign\">\n";
  const auto add = [&](const char* what, const std::string& name) {
    out += std::string("<div><b>") + what + "</b><p>" + xml_escaped(name) + "</p><span>Name</span><p></p>" +
           "<span>Date and signature</span></div>\n";
  };
  add("Programmed by", "");
  add("Reviewed by", s.reviewer);
  add("Released by", "");
  return out + "</div>\n";
}

}  // namespace gouge

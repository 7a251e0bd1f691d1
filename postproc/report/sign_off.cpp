#include "postproc/report/sign_off.h"

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

std::string sign_off_facts(const SignOff& s) {
  std::string out = "<dl class=\"facts\">\n";
  const auto add = [&](const char* name, const std::string& value, const char* css = "") {
    if (!value.empty())
      out += std::string("<div") + css + "><dt>" + name + "</dt><dd>" + xml_escaped(value) + "</dd></div>\n";
  };
  add("Project", s.project);
  add("Reviewer", s.reviewer);
  add("Date", s.date);
  add("Program", std::string(kProgramName) + " " + kProgramVersion);
  add("Command", s.command, " class=\"command\"");
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

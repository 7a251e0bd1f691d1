#include "postproc/report/sign_off.h"

#include "postproc/report/report_model.h"
#include "postproc/report/report_text.h"

namespace gouge {

std::string sign_off_facts(const ReportModel& model) {
  const SignOff& s = model.sign_off;
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

std::string sign_off_lines(const ReportModel& model) {
  std::string out = "<div class=\"sign\">\n";
  const auto add = [&](const char* what, const std::string& name) {
    out += std::string("<div><b>") + what + "</b><p>" + xml_escaped(name) + "</p><span>Name</span><p></p>" +
           "<span>Date and signature</span></div>\n";
  };
  add("Programmed by", "");
  add("Reviewed by", model.sign_off.reviewer);
  add("Released by", "");
  return out + "</div>\n";
}

}  // namespace gouge

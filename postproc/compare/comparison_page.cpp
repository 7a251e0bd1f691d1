#include "postproc/compare/comparison_page.h"

#include "postproc/report/report_model.h"
#include "postproc/report/report_sources.h"
#include "postproc/report/report_text.h"

namespace gouge {

std::string comparison_page_begin(const std::string& title, std::string_view style) {
  const std::string escaped = xml_escaped(title);
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
         "content=\"width=device-width, initial-scale=1\">\n<title>" +
         escaped + "</title>\n<style>" + std::string(kHtmlStyle) + std::string(style) +
         "</style>\n</head>\n<body>\n<main class=\"cards\">\n<h1>" + escaped + "</h1>\n";
}

std::string comparison_banner(ExitCode status, const std::string& counts) {
  const char* css = status == kExitGouges ? "gouges" : status == kExitClean ? "clean" : "not-fully-checked";
  const char* word = status == kExitGouges ? "Worse" : "No worse";
  return std::string("<div class=\"banner ") + css + "\"><strong>" + word + "</strong><div>" +
         (status == kExitNotChecked ? "as far as it was checked: " : "") + xml_escaped(counts) + "</div></div>\n";
}

std::string comparison_number(std::size_t count, const std::string& title, const std::string& css) {
  return "<div class=\"" + (count > 0 ? css : std::string()) + "\"><b>" + std::to_string(count) + "</b><span>" + title +
         "</span></div>";
}

std::string comparison_page_end() {
  return std::string("<footer>") + kProgramName + " " + kProgramVersion + "</footer>\n</main>\n</body>\n</html>\n";
}

}  // namespace gouge

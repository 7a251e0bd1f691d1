#include "postproc/report/assumption_report.h"

#include "postproc/report/html_table.h"
#include "postproc/report/report_text.h"

namespace gouge {

std::string assumptions_html(const CheckResult& result) {
  if (result.assumptions.empty()) return {};
  HtmlTable table({{"Fact"}, {"Taken"}, {"State", "k"}, {"Evidence"}});
  for (const Assumption& fact : result.assumptions) {
    const std::string where = fact.line > 0 ? " (" + fact.file + ":" + std::to_string(fact.line) + ")" : "";
    const std::string name = subject_name(fact.subject) + (fact.object.empty() ? "" : " " + fact.object);
    table.add(html_cell(name, "k") + html_cell(fact.value) +
              html_cell(std::string(basis_name(fact.basis)) + (fact.is_open ? ", open" : ""), "k") +
              html_cell(fact.evidence + where + (fact.is_open ? "; " + fact.remedy : "")));
  }
  return "<h2 id=\"assumptions\">What the verdict rests on</h2>\n" + table.html();
}

}  // namespace gouge

#include "postproc/report/assumption_report.h"

#include "postproc/report/html_table.h"
#include "postproc/report/report_text.h"

namespace gouge {

nlohmann::ordered_json assumptions_json(const CheckResult& result) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const Assumption& fact : result.assumptions) {
    all.push_back({{"fact", subject_name(fact.subject)},
                   {"object", valid_utf8(fact.object)},
                   {"state", basis_name(fact.basis)},
                   {"is_open", fact.is_open},
                   {"value", valid_utf8(fact.value)},
                   {"evidence", valid_utf8(fact.evidence)},
                   {"remedy", valid_utf8(fact.remedy)},
                   {"file", valid_utf8(fact.file)},
                   {"line", fact.line}});
  }
  return all;
}

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

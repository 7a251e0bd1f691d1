#include "postproc/compare/comparison_page.h"
#include "postproc/compare/write_comparison.h"
#include "postproc/report/html_table.h"
#include "postproc/report/report_text.h"

namespace gouge {
namespace {

struct Section {
  Change change;
  const char* title;
  const char* css;  ///< CSS class of the number
};

constexpr Section kSections[] = {{Change::fresh, "New", "bad"},
                                 {Change::deeper, "Deeper", "bad"},
                                 {Change::not_checked, "Not checked any more", "open"},
                                 {Change::gone, "Gone", ""},
                                 {Change::shallower, "Shallower", ""},
                                 {Change::same, "Same", ""}};

// On a phone each finding is a block, with the names of its values.
constexpr const char* kPhoneStyle = R"(
@media screen and (max-width: 960px) {
  td:nth-child(1)::before { content: "No. before "; } td:nth-child(2)::before { content: "now "; }
  td:nth-child(3) { grid-column: 1 / -1; } td:nth-child(3)::before { content: "Line "; }
  td:nth-child(4)::before { content: "Depth before "; } td:nth-child(5)::before { content: "now "; }
  td:nth-child(7)::before { content: "at "; } td:nth-child(8) { grid-column: 1 / -1; }
}
)";

class ComparisonPage {
 public:
  explicit ComparisonPage(const Comparison& comparison) : c_(comparison) {}

  [[nodiscard]] std::string build() const {
    std::string out = comparison_page_begin("Comparison: " + c_.before->file + " to " + c_.after->file, kPhoneStyle);
    out += "<p class=\"soft\">" +
           xml_escaped(c_.before->record.toolpath.file + " (" + c_.before->record.verdict + "), then " +
                       c_.after->record.toolpath.file + " (" + c_.after->record.verdict + ")") +
           "</p>\n" + comparison_banner(c_.exit_status(), change_counts(c_));
    for (const std::string& note : comparison_notes(c_))
      out += "<p class=\"but\">Note: " + xml_escaped(note) + ".</p>\n";
    out += numbers();
    for (const Section& section : kSections) out += table(section);
    return out + comparison_page_end();
  }

 private:
  [[nodiscard]] std::string numbers() const {
    std::string out = "<div class=\"numbers\">";
    for (const Section& section : kSections)
      out += comparison_number(c_.count(section.change), section.title, section.css);
    return out + "</div>\n";
  }

  [[nodiscard]] std::string depths(const StoredResult& result, const std::vector<std::size_t>& findings) const {
    std::string text;
    for (const std::size_t k : findings) {
      const EventRecord& finding = result.findings[k];
      const MoveRecord& worst = result.worst_of(finding);
      text += (text.empty() ? "" : ", ") + (finding.state == MoveState::buried
                                                ? std::string("buried")
                                                : depth_text(worst.depth_mm.value_or(0), c_.after->record.unit));
    }
    return text.empty() ? "-" : text;
  }

  [[nodiscard]] static std::string numbers_of(const StoredResult& result, const std::vector<std::size_t>& findings) {
    std::string text;
    for (const std::size_t k : findings)
      text += (text.empty() ? "" : ", ") + std::to_string(*result.findings[k].number);
    return text.empty() ? "-" : text;
  }

  [[nodiscard]] std::string row(const ComparedFinding& one) const {
    const bool is_new = !one.after.empty();
    const StoredResult& result = is_new ? *c_.after : *c_.before;
    const EventRecord& finding = result.findings[(is_new ? one.after : one.before).front()];
    const MoveRecord& worst = result.worst_of(finding);
    return html_cell(numbers_of(*c_.before, one.before), "n") + html_cell(numbers_of(*c_.after, one.after), "n") +
           html_cell(std::to_string(finding.line), "n") + html_cell(depths(*c_.before, one.before), "n") +
           html_cell(depths(*c_.after, one.after), "n") +
           html_cell(std::string(body_name(finding.body)) + " " + stored_tool_label(finding.tool), "k") +
           html_cell(worst.witness ? point_text(worst.witness->point_mm, result.record.unit) : std::string(), "k") +
           "<td>" + xml_escaped(worst.operation) + "<div class=\"soft\"><code>" + xml_escaped(worst.statement) +
           "</code></div>" + (one.why.empty() ? std::string() : "<div>" + xml_escaped(one.why) + "</div>") + "</td>";
  }

  [[nodiscard]] std::string table(const Section& section) const {
    if (c_.count(section.change) == 0) return {};
    const bool is_old = section.change == Change::gone || section.change == Change::not_checked;
    HtmlTable table({{"No. before", "n"},
                     {"No. now", "n"},
                     {is_old ? "Old line" : "Line", "n"},
                     {"Depth before", "n"},
                     {"Depth now", "n"},
                     {"Body"},
                     {"At, in " + std::string(unit_words(c_.after->record.unit))},
                     {"Operation and statement"}});
    for (const ComparedFinding& one : c_.findings) {
      if (one.change != section.change) continue;
      table.has_room() ? table.add(row(one)) : table.skip();
    }
    return std::string("<h2>") + section.title + "</h2>\n" + table.html();
  }

  const Comparison& c_;
};

}  // namespace

std::string comparison_html(const Comparison& comparison) { return ComparisonPage(comparison).build(); }

}  // namespace gouge

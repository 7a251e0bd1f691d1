#include "postproc/report/html_table.h"

#include <algorithm>
#include <string_view>

#include "postproc/report/report_text.h"

namespace gouge {

namespace {

constexpr std::size_t kMaxUnbroken = 40;  // bytes of a text that keeps on one line

}  // namespace

std::string html_cell(const std::string& text, const char* css) {
  if (std::string_view(css) == "k" && text.size() > kMaxUnbroken) css = "";
  return std::string("<td") + (*css != '\0' ? std::string(" class=\"") + css + "\"" : std::string()) + ">" +
         xml_escaped(text) + "</td>";
}

void HtmlTable::add(const std::string& cells, const std::string& attributes) {
  if (rows_ % kRowsOfPage == 0) pages_.emplace_back();
  ++rows_;
  pages_.back() += "<tr" + attributes + ">" + cells + "</tr>\n";
}

std::string HtmlTable::table(const std::string& rows) const {
  std::string out = "<div class=\"wide\"><table>";
  if (!columns_.empty()) out += "<thead><tr>";
  for (const HtmlColumn& column : columns_)
    out += (*column.css != '\0' ? std::string("<th class=\"") + column.css + "\">" : std::string("<th>")) +
           column.title + "</th>";
  if (!columns_.empty()) out += "</tr></thead>";
  return out + "<tbody>\n" + rows + "</tbody></table></div>\n";
}

std::string HtmlTable::html() const {
  std::string out;
  for (std::size_t page = 0; page < pages_.size(); ++page) {
    const std::size_t first = page * kRowsOfPage;
    const std::string table_of = table(pages_[page]);
    out += page == 0 ? table_of
                     : "<details><summary>" + std::to_string(first + 1) + " to " +
                           std::to_string(std::min(first + kRowsOfPage, rows_)) + " of " +
                           std::to_string(rows_ + skipped_) + "</summary>\n" + table_of + "</details>\n";
  }
  if (skipped_ > 0)
    out += "<p class=\"soft\">and " + std::to_string(skipped_) + " more; the CSV and JSON files have them all</p>\n";
  return out;
}

}  // namespace gouge

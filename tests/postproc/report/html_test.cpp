#include <gtest/gtest.h>

#include "postproc/report/html_table.h"
#include "postproc/report/write_report.h"
#include "tests/postproc/report/small_report.h"

namespace gouge::html_test {
namespace {

std::size_t count_of(const std::string& text, const std::string& what) {
  std::size_t count = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++count;
  return count;
}

TEST(WriteHtml, ReportsVerdictGuaranteeFindingsAndWhatWasNotChecked) {
  const SmallReport report;
  const std::string html = write_html(report.model, {});
  EXPECT_NE(html.find("<div class=\"banner gouges\"><strong>Gouges</strong>"), std::string::npos);
  EXPECT_NE(
      html.find("in the 5 moves that are certified, no gouge deeper than tolerance + resolution = 0.011 mm is missed"),
      std::string::npos);
  EXPECT_NE(html.find("0.333 mm"), std::string::npos);
  EXPECT_NE(html.find("arcs, as yet, are not read"), std::string::npos);
  EXPECT_NE(html.find("sha256:"), std::string::npos);
  EXPECT_NE(html.find("nowhere: its moves are not checked"), std::string::npos);
  EXPECT_EQ(count_of(html, "<table>"), count_of(html, "</table>"));
  EXPECT_EQ(count_of(html, "<tr>") + count_of(html, "<tr data-finding=") + count_of(html, "<tr class="),
            count_of(html, "</tr>"));
}

TEST(WriteHtml, NeedsNothingBesideIt) {
  const SmallReport report;
  const std::string html = write_html(report.model, {{"event_1.png", "\x89PNG bytes", "Finding 1", 2}});
  EXPECT_NE(html.find("src=\"data:image/png;base64,iVBORyBieXRlcw==\""), std::string::npos);
  EXPECT_NE(html.find("<a href=\"#event_1\">picture 1</a>"), std::string::npos);
  EXPECT_EQ(count_of(html, "src=\"http"), 0U);
  EXPECT_EQ(count_of(html, "<link"), 0U);
  EXPECT_EQ(count_of(html, "<script>"), 1U);
  EXPECT_EQ(count_of(html, "<script"), 1U);
}

TEST(WriteHtml, EscapesWhatFilesSay) {
  SmallReport report;
  report.path.file = "<script>alert(1)</script>.apt";
  report.path.operations[0].name = "a\"b<c>";
  const std::string html = write_html(report.model, {});
  EXPECT_EQ(count_of(html, "<script>alert"), 0U);
  EXPECT_NE(html.find("a&quot;b&lt;c&gt;"), std::string::npos);
}

TEST(WriteHtml, ListsTheChangesAndWhatWasLeft) {
  SmallReport report;
  report.add_correction();
  const std::string html = write_html(report.model, {});
  EXPECT_NE(html.find("<h2>Changes</h2>"), std::string::npos);
  EXPECT_NE(html.find("<td>weighted</td>"), std::string::npos);
  EXPECT_NE(html.find("(0, 0, 0.25) mm"), std::string::npos);
  EXPECT_NE(html.find("the shift would exceed 0.5 mm"), std::string::npos);
}

TEST(WriteHtml, SaysWhenNothingWasChanged) {
  SmallReport report;
  report.add_correction();
  EXPECT_EQ(count_of(write_html(report.model, {}), "every other one is the same to the byte."), 1U);
  report.model.correction.changes.clear();
  report.model.correction.uncorrected = {{4, 14, 0, "the tool is buried"}};
  const std::string html = write_html(report.model, {});
  EXPECT_EQ(count_of(html, "<code>out.apt</code>. Nothing was changed."), 1U);
  EXPECT_EQ(count_of(html, "unchanged"), 0U);
  EXPECT_EQ(count_of(html, "<td class=\"n\">4</td><td class=\"n\">-</td><td>the tool is buried</td>"), 1U);
}

TEST(WriteHtml, LetsWideTablesScrollAndKeepsStatesOnOneLine) {
  SmallReport report;
  report.add_correction();
  const std::string html = write_html(report.model, {});
  EXPECT_GT(count_of(html, "<table>"), 5U);
  EXPECT_EQ(count_of(html, "<div class=\"wide\"><table>"), count_of(html, "<table>"));
  EXPECT_EQ(count_of(html, "</table></div>"), count_of(html, "</table>"));
  EXPECT_EQ(count_of(html, ".wide { overflow-x: auto; }"), 1U);
  EXPECT_EQ(count_of(html, ".state { display: inline-block; white-space: nowrap;"), 1U);
}

TEST(WriteHtml, ListsEveryFindingTheWorstFirstInPages) {
  SmallReport report;
  const Event event = report.result.events.front();
  for (std::size_t k = 0; k < 500; ++k) report.result.events.insert(report.result.events.begin(), event);
  const std::string html = write_html(report.model, {});
  EXPECT_EQ(count_of(html, "<details><summary>"), 2U);
  EXPECT_EQ(count_of(html, "<summary>401 to 503 of 503</summary>"), 1U);
  EXPECT_EQ(count_of(html, "<span class=\"state buried\">") + count_of(html, "<span class=\"state gouge\">"), 502U);
  EXPECT_LT(html.find("<span class=\"state buried\">"), html.find("<span class=\"state gouge\">"));
}

TEST(HtmlTable, CountsTheRowsForWhichThereIsNoPage) {
  HtmlTable table(std::vector<HtmlColumn>{{"Move", "n"}});
  for (std::size_t k = 0; k < HtmlTable::kMaxRows + 3; ++k) table.has_room() ? table.add("<td></td>") : table.skip();
  const std::string html = table.html();
  EXPECT_EQ(count_of(html, "<td></td>"), HtmlTable::kMaxRows);
  EXPECT_EQ(count_of(html, "<summary>19801 to 20000 of 20003</summary>"), 1U);
  EXPECT_EQ(count_of(html, "and 3 more; the CSV and JSON files have them all"), 1U);
}

}  // namespace
}  // namespace gouge::html_test

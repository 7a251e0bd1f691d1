#include <gtest/gtest.h>

#include "postproc/report/baseline_text.h"
#include "postproc/report/open_items.h"
#include "postproc/report/write_report.h"
#include "tests/postproc/report/small_report.h"

namespace gouge::review_html_test {
namespace {

bool contains(const std::string& text, const std::string& what) { return text.find(what) != std::string::npos; }

// The gouge of the small report, accepted for `toolpath`.
struct AcceptedReport : SmallReport {
  explicit AcceptedReport(const std::string& toolpath) {
    model.baseline.file = "accepted.json";
    BaselineEntry entry;
    entry.by = "R. Miller";
    entry.date = "2026-11-23";
    entry.reason = "ground <afterwards>";
    entry.toolpath = toolpath;
    entry.line = 12;
    entry.use = BaselineEntry::Use::applied;
    model.baseline.entries = {entry};
    model.baseline.events = {{{0}, true, ""}, {}, {}};
    model.baseline.accepted_moves = 2;
  }
};

TEST(OpenItems, AreTheFindingsInTheOrderOfTheirNumbersAndTheReasons) {
  const SmallReport report;
  const std::string html = open_items_html(report.model);
  EXPECT_LT(html.find("Finding 1</a>, line 14: "), html.find("Finding 2</a>, line 12: 0.333 mm")) << html;
  EXPECT_TRUE(contains(html, "Finding 1</a>, line 14: ")) << html;
  EXPECT_TRUE(contains(html, "2 moves not-checked: arcs, as yet, are not read")) << html;
  EXPECT_FALSE(contains(html, "Finding 3")) << "a near miss is not open";
  EXPECT_TRUE(contains(write_html(report.model, {}), html)) << "the banner has them";
}

TEST(OpenItems, LeaveOutAcceptedFindingsAndCountTheRest) {
  AcceptedReport report("path.apt");
  EXPECT_FALSE(contains(open_items_html(report.model), "line 12"));
  for (int k = 0; k < 6; ++k) report.result.events.push_back(report.result.events.front());
  EXPECT_TRUE(contains(open_items_html(report.model), "<li>and 4 more findings</li>")) << open_items_html(report.model);
}

TEST(Acceptances, HaveAColumnWithTheirReasons) {
  const AcceptedReport report("path.apt");
  const std::string html = write_html(report.model, {});
  EXPECT_TRUE(contains(html, "<th>Acceptance</th>"));
  EXPECT_TRUE(contains(html, "<td class=\"why\">accepted by R. Miller on 2026-11-23: ground &lt;afterwards&gt;</td>"))
      << html;
  EXPECT_FALSE(contains(write_html(SmallReport().model, {}), "<th>Acceptance</th>"));
}

TEST(Acceptances, OfAnotherProgramNameIt) {
  const AcceptedReport report("op20.apt");
  EXPECT_EQ(acceptance_remarks(report.model, 0).front(),
            "accepted by R. Miller on 2026-11-23 through the entry of op20.apt, line 12: ground <afterwards>");
  EXPECT_EQ(accepted_through_others(report.model), 1U);
  EXPECT_EQ(accepted_through_others(AcceptedReport("parts/path.apt").model), 0U);
}

TEST(Acceptances, BelongToAProgramByTheEndOfItsName) {
  EXPECT_TRUE(is_same_program("ops/a.apt", "a.apt"));
  EXPECT_TRUE(is_same_program("a.apt", "/home/ops/a.apt"));
  EXPECT_FALSE(is_same_program("rough/a.apt", "finish/a.apt"));
  EXPECT_FALSE(is_same_program("aa.apt", "a.apt"));
}

TEST(Review, HasItsColumnOnlyWithItsData) {
  const SmallReport report;
  const std::string html = write_html(report.model, {}, {"", {}, "{\"key\":\"k\"}"});
  EXPECT_TRUE(contains(html, "<th>Review</th>"));
  EXPECT_TRUE(contains(html, "<script type=\"application/json\" id=\"review-data\">{\"key\":\"k\"}</script>"));
  EXPECT_FALSE(contains(write_html(report.model, {}), "<th>Review</th>"));
}

TEST(SignOff, LeadsFromReportToReportOfABatch) {
  SmallReport report;
  EXPECT_FALSE(contains(write_html(report.model, {}), "<nav"));
  report.model.sign_off.batch_job = "op 10";
  EXPECT_TRUE(contains(write_html(report.model, {}), "<a href=\"../../index.html#after=op%2010\">Next report</a>"));
}

}  // namespace
}  // namespace gouge::review_html_test

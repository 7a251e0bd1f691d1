#include "postproc/report/operations_html.h"

#include <gtest/gtest.h>

#include "postproc/report/write_report.h"
#include "tests/postproc/report/small_report.h"

namespace gouge::operations_html_test {
namespace {

bool has(const std::string& text, const std::string& what) { return text.find(what) != std::string::npos; }

// The moves of the small report, 10 mm apart and at 600 mm/min.
struct TimedReport : SmallReport {
  TimedReport() {
    for (std::size_t i = 0; i < path.moves.size(); ++i) {
      path.moves[i].end.tip = Vec3(10.0 * static_cast<double>(i), 0, 0);
      path.moves[i].has_start = i > 0;
      if (i > 0) path.moves[i].set_feed({600, FeedUnit::per_minute});
    }
  }
};

TEST(OperationsHtml, StatesTheTimeOfEachOperationAndOfAll) {
  const TimedReport report;
  const std::string html = operations_html(report.model, measure_cycle_times(report.path));
  EXPECT_TRUE(has(html, "<td>finish &lt;1&gt;</td><td class=\"n\">6</td><td class=\"n\">5 s</td>")) << html;
  EXPECT_TRUE(has(html, "<td>operation 2</td><td class=\"n\">2</td><td class=\"n\">2 s</td>")) << html;
  EXPECT_TRUE(has(html, "<tr class=\"sum\"><td>in all</td><td class=\"n\">8</td><td class=\"n\">7 s</td>")) << html;
  EXPECT_TRUE(has(html, "Cycle time: 7 s at the programmed feeds."));
  EXPECT_TRUE(has(html, "1 position to which no motion is known"));
}

TEST(OperationsHtml, StatesWhatTheTimeLeavesOut) {
  TimedReport report;
  report.path.moves[2].set_feed({0, FeedUnit::not_stated});
  report.path.moves[3].kind = MoveKind::rapid;
  report.path.moves[4].set_feed({0.2, FeedUnit::per_revolution});
  const std::string html = operations_html(report.model, measure_cycle_times(report.path));
  EXPECT_TRUE(has(html, "Cycle time: at least 4 s"));
  EXPECT_TRUE(has(html, "1 rapid of 10 mm, whose speed the file does not state"));
  EXPECT_TRUE(has(html, "1 move with a feed per revolution"));
  EXPECT_TRUE(has(html, "1 move whose feed is not known"));
}

TEST(OperationsHtml, SaysThatNoTimeIsKnown) {
  const SmallReport report;
  EXPECT_TRUE(has(write_html(report.model, {}), "The cycle time is not known: no move has a feed per minute."));
}

TEST(ToolsHtml, ShowsEachDrawingBesideItsTool) {
  const SmallReport report;
  const std::string html = write_html(report.model, {}, {"", {"<svg>ball</svg>", ""}});
  EXPECT_TRUE(has(html, "<td class=\"k\">T1</td><td class=\"tool\"><svg>ball</svg></td><td>ball D10</td>")) << html;
  EXPECT_TRUE(has(html, "Each tool is drawn at a scale of its own."));
  EXPECT_FALSE(has(write_html(report.model, {}), "Each tool is drawn"));
}

}  // namespace
}  // namespace gouge::operations_html_test

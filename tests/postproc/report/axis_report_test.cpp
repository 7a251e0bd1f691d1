#include <gtest/gtest.h>

#include <limits>

#include "postproc/report/axis_chart.h"
#include "postproc/report/axis_text.h"
#include "postproc/report/write_report.h"
#include "tests/postproc/report/tilted_report.h"

namespace gouge::axis_report_test {
namespace {

std::size_t count_of(const std::string& text, const std::string& what) {
  std::size_t count = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++count;
  return count;
}

TEST(AxisText, HasThreeDigits) {
  constexpr double kDegree = std::numbers::pi / 180;
  EXPECT_EQ(angle_text(12.345 * kDegree, DegreeSign::word), "12.3 deg");
  EXPECT_EQ(angle_text(0.5 * kDegree, DegreeSign::sign), "0.5°");
  EXPECT_EQ(angle_text(99.96 * kDegree, DegreeSign::word), "100 deg");
  EXPECT_EQ(angle_text(0, DegreeSign::word), "0 deg");
  EXPECT_EQ(turn_rate_text(0.5 * kDegree, LengthUnit::mm, DegreeSign::word), "0.5 deg/mm");
  EXPECT_EQ(turn_rate_text(0.5 * kDegree, LengthUnit::inch, DegreeSign::word), "12.7 deg/in");
  EXPECT_EQ(bending_text(0.01234, LengthUnit::mm), "0.0123");
  EXPECT_EQ(bending_text(3.2149e-5, LengthUnit::mm), "3.21e-05");
  EXPECT_EQ(bending_text(9.9999e-5, LengthUnit::mm), "1e-04");
  EXPECT_EQ(bending_text(1.5e-120, LengthUnit::mm), "1.5e-120");
  EXPECT_EQ(bending_text(1, LengthUnit::inch), "16387");
}

TEST(AxisText, HasTimesAsPeopleReadThem) {
  EXPECT_EQ(feed_time_text(0), "0 s");
  EXPECT_EQ(feed_time_text(4.214), "4.21 s");
  EXPECT_EQ(feed_time_text(59.99), "60 s");
  EXPECT_EQ(feed_time_text(724.3), "12 min 4 s");
  EXPECT_EQ(feed_time_text(3599.7), "60 min 0 s");
  EXPECT_EQ(feed_time_text(3 * 3600 + 299), "3 h 5 min");
  EXPECT_EQ(feed_time_text(std::numeric_limits<double>::infinity()), "without end");
}

TEST(AxisText, TheSummaryHasTurnsTiltsAndTimes) {
  const TiltedReport report;
  const std::string text = summary_text(report.model);
  EXPECT_EQ(count_of(text,
                     "\naxis turns: up to 0.978 deg/mm at line 90 (before 0.0588 deg/mm), 0.998 deg in a move "
                     "(before 0.06 deg), J 6.38e-04 rad^2/mm^3 (before 9.97e-08)\n"),
            1U)
      << text;
  EXPECT_EQ(count_of(text, "\ntilted: 39 positions by up to 12 deg at line 70\n"), 1U) << text;
  EXPECT_EQ(count_of(text, "\nfeed time: 4.9 s (before 4.9 s); turning by at most 600 deg/min 6.42 s (before 4.9 s)\n"),
            1U)
      << text;
}

TEST(AxisText, TheSummaryIsAsItWasWhereTheAxisStands) {
  TiltedReport report;
  for (Toolpath* path : {&report.before, &report.path})
    for (Move& move : path->moves) move.end.axis = Vec3::UnitZ();
  report.measure();
  EXPECT_EQ(count_of(summary_text(report.model), "feed time: "), 1U) << "asked for with --max-rotary-speed";
  report.model.correction.axes->max_rotary_deg_per_min.reset();
  const std::string text = summary_text(report.model);
  EXPECT_EQ(count_of(write_html(report.model, {}), "Tool axis"), 0U);
  report.model.correction.axes.reset();
  EXPECT_EQ(text, summary_text(report.model));
}

TEST(AxisText, CountsMovesWithoutAFeed) {
  TiltedReport report;
  report.path.moves[5].set_feed({});
  report.measure();
  EXPECT_EQ(count_of(summary_text(report.model), "; not counted: 1 move without a feed per minute\n"), 1U);
  EXPECT_EQ(count_of(axis_section(report.model), "Moves without a feed per minute"), 1U);
}

TEST(AxisSection, HasATableAndAChartOfTheRun) {
  const TiltedReport report;
  const std::string html = write_html(report.model, {});
  EXPECT_EQ(count_of(html, "<td>Largest tilt</td><td class=\"n\"></td><td class=\"n\">12° (line 70)</td>"), 1U);
  EXPECT_EQ(count_of(html, "<td>Feed time, turning by at most 600°/min</td>"), 1U);
  EXPECT_EQ(count_of(html, "<td>Turns on the spot"), 0U);
  EXPECT_EQ(count_of(html, "<svg"), 1U);
  EXPECT_EQ(count_of(html, "<figcaption>Lines 51 to 90: 40 moves over 41.27 mm, tilted by up to 12° (line 70)"), 1U);
  EXPECT_EQ(count_of(html, "<polyline class=\"before\""), 2U) << "lead and side";
  EXPECT_EQ(count_of(html, "<polyline class=\"after\""), 2U);
  EXPECT_EQ(count_of(html, ">lead tilt</text>") + count_of(html, ">side tilt</text>"), 2U);
  EXPECT_EQ(count_of(html, ">length of the path in mm</text>"), 1U);
  EXPECT_EQ(count_of(html, "nan") + count_of(html, "inf,"), 0U);
}

TEST(AxisSection, CountsTurnsOnTheSpotAndTheRunsItDoesNotDraw) {
  TiltedReport report;
  report.path.moves[60].end.tip = report.path.moves[59].end.tip;
  report.measure();
  report.model.correction.axes->tilts.runs_left_out = 3;
  EXPECT_EQ(count_of(summary_text(report.model), "), 1 turn on the spot (before 0)\n"), 1U);
  const std::string html = axis_section(report.model);
  EXPECT_EQ(count_of(html, "<td>Turns on the spot, the largest of them</td><td class=\"n\">0</td><td class=\"n\">1, "),
            1U);
  EXPECT_EQ(count_of(html, "and 3 shorter runs"), 1U);
}

TEST(AxisSection, IsInInchesForAnInchPath) {
  TiltedReport report;
  report.path.unit = LengthUnit::inch;
  const std::string html = axis_section(report.model);
  EXPECT_EQ(count_of(html, ">length of the path in inches</text>"), 1U);
  EXPECT_EQ(count_of(html, "24.8°/in (line 90)"), 1U);
}

TEST(AxisChart, OfALongRunStaysSmallAndKeepsItsPeak) {
  TiltedRun run;
  for (std::size_t i = 0; i <= 1'000'000; ++i) run.curve.push_back({static_cast<double>(i), 0, 0, 0.001, 0});
  run.curve[300'003].lead_after_rad = 1;
  run.end_mm = 1e6;
  const std::string svg = axis_chart(run, LengthUnit::mm);
  EXPECT_LT(svg.size(), 300'000U);
  EXPECT_NE(svg.find(">60°</text>"), std::string::npos) << "1 rad is 57 degrees, and air";
}

TEST(AxisChart, OfARunOfNoLengthIsNone) {
  EXPECT_EQ(axis_chart({}, LengthUnit::mm), "");
  TiltedRun run;
  run.curve = {{0, 0, 0, 0, 0}, {0, 0, 0, 0.1, 0}};
  EXPECT_EQ(axis_chart(run, LengthUnit::mm), "");
  run.curve[1].length_mm = std::numeric_limits<double>::infinity();
  EXPECT_EQ(axis_chart(run, LengthUnit::mm), "");
  run.curve[1].length_mm = 1e300;
  EXPECT_NE(axis_chart(run, LengthUnit::mm), "");
}

}  // namespace
}  // namespace gouge::axis_report_test

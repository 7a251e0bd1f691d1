#include <gtest/gtest.h>

#include <limits>

#include "postproc/report/remedies.h"
#include "postproc/report/report_text.h"
#include "postproc/report/stickout_text.h"
#include "postproc/report/tightness.h"
#include "postproc/report/write_report.h"
#include "tests/postproc/report/small_report.h"
#include "tests/support/plain_text.h"

namespace gouge::findings_text_test {
namespace {

TEST(FindingsText, CountsTheRecordsWrittenAndThoseChangedButNotFreed) {
  SmallReport report;
  report.add_correction();
  report.model.correction.written = {{WrittenKind::changed, 4}, {WrittenKind::changed, 5}, {WrittenKind::added, 6}};
  report.model.correction.uncorrected = {{4, 14, 0.2, "no way out"}, {5, 15, 0.1, "no way out", true}};
  const std::string text = findings_text(report.model);
  EXPECT_NE(text.find("records: 2 changed, 1 added, 0 removed; every other one is the same to the byte\n"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find(", 1 left as it was, 1 changed but not freed"), std::string::npos) << text;
  EXPECT_NE(text.find(":15: not freed: 0.100 mm, move 5: no way out"), std::string::npos) << text;
}

TEST(FindingsText, ReportsEveryFindingAndTheSummary) {
  const SmallReport report;
  EXPECT_EQ(
      findings_text(report.model),
      "path.apt:12: gouge: 0.333 mm cutter T1 at (12.3, 4.5, 6.7), move 2 t=0.42 (2 moves, 1-2), lines 11-12, operation "
      "finish <1>, tool ball D10\n"
      "path.apt:13: near: 0.125 mm left holder T1 against fixture vise.stl at (1, 2, 3), move 3 t=0.5, operation "
      "finish <1>, tool ball D10\n"
      "path.apt:14: buried: cutter T1 lies inside a solid, no surface within the tool, move 4, operation finish <1>, "
      "tool ball D10\n"
      "path.apt:15: not certified: budget of 10 bounds spent, move 5\n"
      "path.apt:16: not checked: arcs, as yet, are not read (2 moves, the first is move 6)\n"
      "path.apt against part.stl, vise.stl\n"
      "gouges: 1 finding in 2 of 8 moves, the deepest 0.333 mm at line 12; the tool is buried in 1 move\n"
      "moves: 1 clean, 1 near, 2 gouge, 1 buried, 1 not certified, 2 not checked\n"
      "guarantee: in the 5 moves that are certified, no gouge deeper than tolerance + resolution = 0.011 mm is "
      "missed, and where none is reported the tool reaches at most 3 times that into a solid; it does not cover "
      "the 3 moves not checked or not certified\n");
}

TEST(FindingsText, TheSummaryBreaksAtTheWidthOfATerminal) {
  const SmallReport report;
  constexpr std::size_t kColumns = 60;
  const std::vector<std::string> lines = lines_of(summary_text(report.model, false, kColumns));
  EXPECT_GT(lines.size(), lines_of(summary_text(report.model)).size());
  for (const std::string& line : lines) EXPECT_LE(line.size(), kColumns) << line;
}

TEST(FindingsText, StatesTheFeedAndThePoseOfTheToolOnRequest) {
  SmallReport report;
  report.path.moves[2].set_feed({800, FeedUnit::per_minute});
  report.path.moves[2].spindle_rpm = 12000;
  FindingsView view;
  view.has_statements = true;
  const std::string text = findings_text(report.model, view);
  EXPECT_NE(text.find(", tool ball D10, feed 800 mm/min, spindle 12000 rpm\n"), std::string::npos) << text;
  EXPECT_NE(text.find("\n         tip ("), std::string::npos) << text;
  EXPECT_EQ(findings_text(report.model).find("tip ("), std::string::npos);
}

TEST(FindingsText, CountsGougesThatMayComeFromTheFacetsOfThePart) {
  SmallReport report;
  const auto said = [&](double error_mm) {
    report.model.chord_errors_mm.assign(report.result.events.size(), error_mm);
    return summary_text(report.model).find("1 of 1 finding in the part may come from the facets of the STL alone");
  };
  EXPECT_EQ(said(0), std::string::npos);
  EXPECT_EQ(said(0.32), std::string::npos) << "0.333 mm, of which 0.01 mm are tolerated";
  EXPECT_NE(said(0.324), std::string::npos);
}

TEST(FindingsText, AViewListsLessAndCountsTheRest) {
  const SmallReport report;
  FindingsView deepest;
  deepest.is_deepest_first = true;
  EXPECT_EQ(list_events(report.model, deepest).events, (std::vector<std::size_t>{2, 0, 1})) << "buried, gouge, near";
  FindingsView two;
  two.most = 2;
  const ListedFindings listed = list_events(report.model, two);
  EXPECT_EQ(listed.events, (std::vector<std::size_t>{0, 2})) << "the two worst, in the order of the path";
  EXPECT_EQ(listed.more, 1U);
  FindingsView one = two;
  one.most = 1;
  EXPECT_NE(findings_text(report.model, one).find("and 2 more, the deepest 0.333 mm (--max-findings all lists them)\n"),
            std::string::npos);
  FindingsView deep;
  deep.min_depth_mm = 100;
  const ListedFindings shallow = list_events(report.model, deep);
  EXPECT_EQ(shallow.events, std::vector<std::size_t>{2}) << "how deep a buried tool is, is not known";
  EXPECT_EQ(shallow.shallower, 2U);
}

TEST(FindingsText, WhatMayBeDeepEnoughByItsUpperBoundIsListed) {
  SmallReport report;
  report.result.verdicts[1].depth_upper_mm = 7;
  FindingsView view;
  view.min_depth_mm = 6;
  EXPECT_EQ(list_events(report.model, view).events, (std::vector<std::size_t>{0, 2}));
}

TEST(FindingsText, ColoursAreTheOnlyDifference) {
  const SmallReport report;
  FindingsView view;
  view.is_coloured = true;
  const std::string coloured = findings_text(report.model, view);
  EXPECT_NE(coloured.find("\x1b[1mpath.apt:12:\x1b[0m \x1b[1;31mgouge:\x1b[0m 0.333 mm"), std::string::npos)
      << coloured;
  EXPECT_EQ(without_colours(coloured), findings_text(report.model));
}

TEST(DepthText, NeverContradictsTheLimitBesideIt) {
  CheckOptions limits;  // 0.01 and 0.011
  const auto text = [&](double depth_mm) { return depth_text(depth_mm, LengthUnit::mm, limits); };
  EXPECT_EQ(text(0.0112), "0.0112 mm");
  EXPECT_EQ(text(0.011), "0.011 mm");
  EXPECT_EQ(text(0.0104), "0.0104 mm");
  EXPECT_EQ(text(0.010004), "0.010004 mm");
  EXPECT_EQ(text(0.00996), "0.00996 mm");
  EXPECT_EQ(text(0.2134), "0.213 mm") << "far from every limit";
  limits.near_miss_mm = 0.5;
  EXPECT_EQ(text(0.4996), "0.4996 mm");
  EXPECT_EQ(depth_text(0.0112, LengthUnit::inch, limits), "0.00044 in");
  EXPECT_EQ(grouped_text(999), "999");
  EXPECT_EQ(grouped_text(4957), "4,957");
  EXPECT_EQ(grouped_text(1234567), "1,234,567");
}

TEST(StatementLines, AreThoseOfTheFileAndEnd) {
  Toolpath path;
  path.source = "GOTO/1,\t$\r\n 2\n";
  path.statements = {SourceStatement{1, 0, path.source.size()}};
  path.moves.resize(2);
  path.moves[0].statement = 0;
  EXPECT_EQ(statement_lines(path, 0), (std::vector<std::string>{"GOTO/1, $", " 2"}));
  EXPECT_TRUE(statement_lines(path, 1).empty()) << "it has none";
  path.source = std::string("\x01\x02\0GOTO", 7);
  path.statements = {SourceStatement{1, 0, 7}};
  EXPECT_TRUE(statement_lines(path, 0).empty()) << "no text";
  path.source = "a\nb\nc\nd\n";
  path.statements = {SourceStatement{1, 0, 8}};
  EXPECT_EQ(statement_lines(path, 0), (std::vector<std::string>{"a", "b", "c ..."}));
  path.source = std::string(300, 'x');
  path.statements = {SourceStatement{1, 0, 300}};
  EXPECT_EQ(statement_lines(path, 0), std::vector<std::string>{std::string(200, 'x') + " ..."});
}

TEST(FindingsText, SaysCleanOnlyWhenEverythingWasChecked) {
  SmallReport report;
  report.result.verdicts.assign(8, MoveVerdict{});
  report.result.events.clear();
  report.result.counts = {8, 0, 0, 0, 0, 0, 0};
  EXPECT_EQ(lines_of(findings_text(report.model))[1], "clean: no gouge in 8 moves");
  report.result.counts = {6, 0, 0, 0, 2, 0, 2};
  EXPECT_EQ(lines_of(summary_text(report.model))[1],
            "clean: no gouge in the 6 moves checked; 2 rapids left out as asked");
  EXPECT_EQ(lines_of(summary_text(report.model))[2], "moves: 6 clean, 2 not checked (2 rapids left out as asked)");
  report.result.counts = {5, 0, 0, 0, 3, 0, 2};
  EXPECT_EQ(lines_of(summary_text(report.model))[1],
            "not fully checked: no gouge found, but 1 of 8 moves could not be checked or certified");
}

TEST(FindingsText, NamesBeneathTheVerdictTheOptionThatSettlesWhatIsNotChecked) {
  SmallReport report;
  MoveVerdicts& verdicts = report.result.verdicts;
  for (MoveVerdict& verdict : verdicts) verdict = MoveVerdict{};
  const auto leave = [&](std::size_t move, const Reason& reason) {
    verdicts[move].state = MoveState::not_checked;
    verdicts[move].reason = reason;
  };
  const Reason compensated{
      Reason::Kind::of_path, Body::cutter, 0,
      std::string("compensated by CUTCOM: the positions need not be the cutter centre: CUTCOM at line 5")};
  leave(0, compensated);
  const std::string claim = " not checked: it states that positions under CUTCOM are the cutter's centre";
  EXPECT_EQ(reservations(report.model),
            std::vector<std::string>{"--cutcom centre settles the reason of the move that is" + claim});
  leave(1, {Reason::Kind::of_path, Body::cutter, 0,
            std::string("starts at a position compensated by CUTCOM, which need not be the cutter centre")});
  leave(2, {Reason::Kind::rapid_skipped});
  EXPECT_EQ(lines_of(summary_text(report.model))[2],
            "note: --cutcom centre settles the reason of all 2 moves that are" + claim);
  leave(3, {Reason::Kind::of_path, Body::cutter, 0, std::string("a curve that is not understood")});
  EXPECT_EQ(reservations(report.model),
            std::vector<std::string>{"--cutcom centre settles the reason of 2 of the 3 moves that are" + claim});
  for (const std::size_t move : {4U, 5U, 6U}) leave(move, {Reason::Kind::tool_undefined});
  ASSERT_EQ(reservations(report.model).size(), 2U);
  EXPECT_EQ(reservations(report.model)[0],
            "--tools LIBRARY settles the reason of 3 of the 6 moves that are not checked: it defines the tools that "
            "the file only numbers or names");
}

TEST(FindingsText, SaysBesideTheVerdictWhatItDoesNotCover) {
  SmallReport report;
  EXPECT_TRUE(reservations(report.model).empty());
  for (ToolFacts& tool : report.model.tools) tool.has_holder = false;
  const std::vector<std::string> lines = lines_of(summary_text(report.model));
  EXPECT_EQ(lines[2], "note: ball D10, long, \"thin\" have no holder, so none is checked");
  report.model.tools.assign(2, ToolFacts{"T0", "tools.json", "", false});
  EXPECT_EQ(reservations(report.model)[0], "T0 has no holder, so none is checked") << "two tools of one number";
  for (int number = 1; number < 7; ++number)
    report.model.tools.push_back(ToolFacts{"T" + std::to_string(number), "tools.json", "", false});
  EXPECT_EQ(reservations(report.model)[0], "T0, T1, T2, T3, T4 and 2 more have no holder, so none is checked");
}

TEST(FindingsText, NotesFewCutsThatStayAwayFromThePart) {
  SmallReport report;
  report.result.closest_approach = ClosestApproach{3, 3, 8.59, {}, 8.58};
  const std::string note =
      "at none of 3 cutting positions is the tool nearer than 8.5 mm to the part; check units and --place";
  EXPECT_EQ(reservations(report.model), std::vector{note});
  report.result.closest_approach->nearest_mm = 1.5;
  EXPECT_TRUE(reservations(report.model).empty());
  report.result.closest_approach->nearest_mm.reset();
  report.result.assumptions.push_back({.subject = Subject::placement, .basis = Basis::stated});
  EXPECT_TRUE(reservations(report.model).empty()) << "the user states that the part is in its place";
}

TEST(FindingsText, AnOpenFactKeepsAPathOfCleanMovesFromBeingClean) {
  SmallReport report;
  report.result.events.clear();
  report.result.counts = {8, 0, 0, 0, 0, 0, 0};
  report.result.assumptions = {{.subject = Subject::path_unit,
                                .basis = Basis::unknown,
                                .value = "mm",
                                .evidence = "no unit",
                                .remedy = "give --path-units"},
                               {.subject = Subject::tool, .object = "T1", .basis = Basis::stated, .value = "ball"}};
  settle(report.result.assumptions, {}, false);
  EXPECT_EQ(overall_verdict(report.model), OverallVerdict::not_fully_checked);
  const std::vector<std::string> lines = lines_of(summary_text(report.model));
  EXPECT_EQ(lines[1], "not fully checked: no gouge found, but 1 fact that the verdict rests on is not established");
  EXPECT_EQ(lines[2], "not established: path-unit (unknown): no unit; give --path-units");
  EXPECT_NE(lines.back().find("rests on: path-unit mm (unknown), tool T1 ball (stated)"), std::string::npos);
  EXPECT_NE(write_junit(report.model).find("<error message=\"path-unit (unknown): no unit; give --path-units\""),
            std::string::npos);
  EXPECT_NE(write_json(report.model).find("\"state\": \"unknown\""), std::string::npos);
  settle(report.result.assumptions, {{Subject::path_unit, {}}}, false);
  EXPECT_EQ(overall_verdict(report.model), OverallVerdict::clean);
}

TEST(FindingsText, SaysWhichDepthsAreKnownLessCloselyThanAsked) {
  SmallReport report;
  EXPECT_EQ(depth_gaps_text(report.model), "");
  report.result.verdicts[2].depth_upper_mm = 0.3539;
  report.result.largest_gap_mm = 0.0206;
  EXPECT_EQ(
      lines_of(findings_text(report.model))[0],
      "path.apt:12: gouge: 0.333 mm (at most 0.354 mm) cutter T1 at (12.3, 4.5, 6.7), move 2 t=0.42 (2 moves, 1-2), "
      "lines 11-12, operation finish <1>, tool ball D10");
  EXPECT_EQ(lines_of(summary_text(report.model))[2],
            "note: the depth of 1 of 2 gouging moves is certified to 0.0206 mm only, not to the resolution of 0.001 "
            "mm: move 2, line 12, is at least 0.333 mm and at most 0.354 mm deep");
  report.model.options.resolution_mm = 0.03;
  EXPECT_EQ(depth_gaps_text(report.model), "");
  EXPECT_EQ(lines_of(findings_text(report.model))[0].find("at most"), std::string::npos);
}

TEST(FindingsText, SaysWhichOvercutsAreLowerBounds) {
  SmallReport report;
  const auto set = [&](std::size_t move, double overcut, double upper) {
    report.result.verdicts[move].overcut = OvercutBounds{overcut, upper};
    report.result.worst_overcut_mm = std::max(report.result.worst_overcut_mm, overcut);
  };
  set(1, 7.5, 9.5);
  set(2, 9.2, 9.2009);
  EXPECT_EQ(overcut_gaps_text(report.model),
            "a lower bound in 1 of 2 gouging moves; the true one may be up to 2 mm larger (move 1)");
  const std::vector<std::string> lines = lines_of(summary_text(report.model));
  EXPECT_NE(lines[1].find(", overcut 9.200 to 9.500 mm;"), std::string::npos) << lines[1];
  EXPECT_EQ(lines[3], "overcut: " + overcut_gaps_text(report.model));
  EXPECT_NE(write_csv(report.model).find(",,,7.5,9.5\n"), std::string::npos);
  set(1, 7.5, 7.5001);
  EXPECT_EQ(overcut_gaps_text(report.model), "");
  EXPECT_NE(lines_of(summary_text(report.model))[1].find(", overcut 9.200 to 9.201 mm;"), std::string::npos);
}

TEST(FindingsText, SaysHowNearTheToolComesToThePart) {
  SmallReport report;
  const auto text = [&](std::optional<double> nearest, std::optional<double> median) {
    report.result.closest_approach = ClosestApproach{2425, 400, nearest, median, 0};
    EXPECT_NE(summary_text(report.model)
                  .find("\nclosest approach to the part: " + closest_approach_text(report.model) + "\n"),
              std::string::npos);
    return closest_approach_text(report.model);
  };
  EXPECT_EQ(text(0.0, 0.0042), "touching; half of the 400 cutting positions examined (of 2425) are touching");
  EXPECT_EQ(text(0.834, 4.2),
            "within 0.84 mm; half of the 400 cutting positions examined (of 2425) are within 4.20 mm");
  EXPECT_EQ(text({}, {}),
            "not within 20 mm; half of the 400 cutting positions examined (of 2425) are not within 20 mm");
  report.result.closest_approach = ClosestApproach{37, 37, 1.0, 2.0, 1.0};
  EXPECT_EQ(closest_approach_text(report.model), "within 1.00 mm; half of the 37 cutting positions are within 2.00 mm");
  report.result.closest_approach = ClosestApproach{1, 1, 2.5, 14.4, 14.3};
  EXPECT_EQ(closest_approach_text(report.model), "within 2.50 mm along the path");
  report.result.closest_approach.reset();
  EXPECT_EQ(closest_approach_text(report.model), "");
}

TEST(FindingsText, ReportsTheCurvesThatBecameStraight) {
  SmallReport report;
  report.add_correction();
  EXPECT_EQ(findings_text(report.model).find("became"), std::string::npos);
  report.model.correction.curves = 2;
  report.model.correction.straight_moves = 79;
  EXPECT_NE(findings_text(report.model).find(" inserted, 2 curves became 79 straight moves, 1 left as it was"),
            std::string::npos);
}

TEST(FindingsText, ReportsTheCorrection) {
  SmallReport report;
  report.add_correction();
  const std::string text = findings_text(report.model);
  EXPECT_NE(text.find("path.apt:14: not corrected: 0.800 mm, move 4: the shift would exceed 0.5 mm\n"),
            std::string::npos);
  EXPECT_NE(
      text.find("corrected: 1 position moved by up to 0.250 mm, 1 inserted, 1 left as it was; written to out.apt\n"),
      std::string::npos);
}

TEST(FindingsText, GivesABuriedPositionNoDepth) {
  SmallReport report;
  report.add_correction();
  report.model.correction.uncorrected = {{4, 14, 0, "the tool is buried"}};
  EXPECT_NE(findings_text(report.model).find("path.apt:14: not corrected: move 4: the tool is buried\n"),
            std::string::npos);
}

TEST(FindingsText, IsInInchesForAnInchPath) {
  SmallReport report;
  report.path.unit = LengthUnit::inch;
  const std::string text = findings_text(report.model);
  EXPECT_NE(text.find("gouge: 0.0131 in cutter T1 at (0.4843, 0.1772, 0.2638), move 2"), std::string::npos);
  EXPECT_NE(text.find("= 0.0004331 in is missed"), std::string::npos);
}

}  // namespace
}  // namespace gouge::findings_text_test

#include <gtest/gtest.h>

#include <limits>
#include <sstream>

#include "postproc/report/cure_text.h"
#include "postproc/report/report_text.h"
#include "postproc/report/stickout_text.h"
#include "postproc/report/tightness.h"
#include "postproc/report/write_report.h"
#include "tests/postproc/report/small_report.h"

namespace gouge {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

TEST(FindingsText, CountsTheRecordsWrittenAndThoseChangedButNotFreed) {
  SmallReport report;
  report.add_correction();
  report.model.correction.written = {{"changed", 4}, {"changed", 5}, {"added", 6}};
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
      "path.apt:12: gouge: 0.333 mm cutter T1 at (12.3, 4.5, 6.7), move 2 t=0.42 (2 moves, 1-2), operation finish <1>\n"
      "path.apt:13: near: 0.125 mm left holder T1 against fixture vise.stl at (1, 2, 3), move 3 t=0.5, operation "
      "finish <1>\n"
      "path.apt:14: buried: cutter T1 lies inside a solid, no surface within the tool, move 4, operation finish <1>\n"
      "path.apt:15: not certified: budget of 10 bounds spent, move 5\n"
      "path.apt:16: not checked: arcs, as yet, are not read (2 moves, the first is move 6)\n"
      "path.apt against part.stl, vise.stl\n"
      "gouges: 1 finding in 2 of 8 moves, the deepest 0.333 mm at line 12; the tool is buried in 1 move\n"
      "moves: 1 clean, 1 near, 2 gouge, 1 buried, 1 not certified, 2 not checked\n"
      "guarantee: in the 5 moves that are certified, no gouge deeper than tolerance + resolution = 0.011 mm is "
      "missed, and where none is reported the tool reaches at most 3 times that into a solid; it does not cover "
      "the 3 moves not checked or not certified\n");
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
  std::string plain;
  for (std::size_t at = 0; at < coloured.size(); ++at) {
    if (coloured[at] == '\x1b') {
      at = coloured.find('m', at);
    } else {
      plain += coloured[at];
    }
  }
  EXPECT_EQ(plain, findings_text(report.model));
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
  EXPECT_EQ(lines_of(summary_text(report.model))[1], "clean: no gouge in 8 moves");
  EXPECT_EQ(lines_of(summary_text(report.model))[2], "moves: 6 clean, 2 not checked (2 rapids left out as asked)");
  report.result.counts = {5, 0, 0, 0, 3, 0, 2};
  EXPECT_EQ(lines_of(summary_text(report.model))[1],
            "not fully checked: no gouge found, but 1 of 8 moves could not be checked or certified");
}

TEST(FindingsText, SaysBesideTheVerdictWhatItDoesNotCover) {
  SmallReport report;
  EXPECT_TRUE(reservations(report.model).empty());
  report.model.notes.push_back(make_warning(kSceneMisplaced, "the part is far away", "path.apt"));
  for (ToolFacts& tool : report.model.tools) tool.has_holder = false;
  const std::vector<std::string> lines = lines_of(summary_text(report.model));
  EXPECT_EQ(lines[2], "note: the part is far away");
  EXPECT_EQ(lines[3], "note: ball D10, long, \"thin\" have no holder, so none is checked");
  report.model.tools.assign(7, ToolFacts{"T1", "tools.json", "", false});
  EXPECT_EQ(reservations(report.model)[1], "T1, T1, T1, T1, T1 and 2 more have no holder, so none is checked");
}

TEST(FindingsText, SaysWhichDepthsAreKnownLessCloselyThanAsked) {
  SmallReport report;
  EXPECT_EQ(depth_gaps_text(report.model), "");
  report.result.verdicts[2].depth_upper_mm = 0.3539;
  report.result.largest_gap_mm = 0.0206;
  EXPECT_EQ(
      lines_of(findings_text(report.model))[0],
      "path.apt:12: gouge: 0.333 mm (at most 0.354 mm) cutter T1 at (12.3, 4.5, 6.7), move 2 t=0.42 (2 moves, 1-2), "
      "operation finish <1>");
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
    report.result.verdicts[move].overcut_mm = overcut;
    report.result.verdicts[move].overcut_upper_mm = upper;
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
    report.model.closeness = Closeness{2425, 400, nearest, median, 0};
    EXPECT_NE(summary_text(report.model).find("\nclosest approach to the part: " + closeness_text(report.model) + "\n"),
              std::string::npos);
    return closeness_text(report.model);
  };
  EXPECT_EQ(text(0.0, 0.0042), "touching; half of the 400 cutting positions examined (of 2425) are touching");
  EXPECT_EQ(text(0.834, 4.2),
            "within 0.84 mm; half of the 400 cutting positions examined (of 2425) are within 4.20 mm");
  EXPECT_EQ(text({}, {}),
            "not within 20 mm; half of the 400 cutting positions examined (of 2425) are not within 20 mm");
  report.model.closeness = Closeness{37, 37, 1.0, 2.0, 1.0};
  EXPECT_EQ(closeness_text(report.model), "within 1.00 mm; half of the 37 cutting positions are within 2.00 mm");
  report.model.closeness.reset();
  EXPECT_EQ(closeness_text(report.model), "");
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

TEST(OverallVerdict, NeverCallsAnOpenQuestionClean) {
  CheckResult result;
  EXPECT_EQ(overall_verdict(result), OverallVerdict::clean);
  result.counts.not_certified = 1;
  EXPECT_EQ(exit_status(overall_verdict(result)), 4);
  result.counts.buried = 1;
  EXPECT_EQ(exit_status(overall_verdict(result)), 1);
}

TEST(WriteCsv, HasOneRowForEveryMoveAndTheContractsColumns) {
  const SmallReport report;
  const std::vector<std::string> lines = lines_of(write_csv(report.model));
  ASSERT_EQ(lines.size(), 9U);
  EXPECT_EQ(lines[0],
            "move,line,kind,tool,state,depth,depth_upper,t,body,against,x,y,z,nx,ny,nz,mesh,triangle,operation,reason,"
            "clearance,overcut,overcut_upper");
  EXPECT_EQ(lines[1], "0,10,rapid,1,clean,0,0,,,,,,,,,,,,finish <1>,,,,");
  EXPECT_EQ(lines[3], "2,12,feed,1,gouge,0.3333,0.3338,0.42,cutter,part,12.3,4.5,6.7,0,0,1,part.stl,5,finish <1>,,,,");
  EXPECT_EQ(lines[4], "3,13,feed,1,near,0,0,,,,,,,,,,,,finish <1>,,0.125,,");
  EXPECT_EQ(lines[5], "4,14,feed,1,buried,,,,,,,,,,,,,,finish <1>,,,,");
  EXPECT_EQ(lines[6], "5,15,feed,1,not-certified,0,0.5,,,,,,,,,,,,finish <1>,budget of 10 bounds spent,,,");
  EXPECT_EQ(lines[7], "6,16,feed,\"long, \"\"thin\"\"\",not-checked,,,,,,,,,,,,,,,\"arcs, as yet, are not read\",,,");
}

// What is in the operation's column of the first move.
std::string operation_cell(const std::string& name) {
  SmallReport report;
  report.path.operations[0].name = name;
  const std::string row = lines_of(write_csv(report.model))[1];
  const std::string before = "0,10,rapid,1,clean,0,0,,,,,,,,,,,,";  // 18 columns
  EXPECT_EQ(row.substr(0, before.size()), before);
  return row.substr(before.size(), row.size() - before.size() - std::string(",,,,").size());
}

TEST(WriteCsv, HandsNoFormulaToASpreadsheet) {
  EXPECT_EQ(operation_cell("=1+1"), "'=1+1");
  EXPECT_EQ(operation_cell("=HYPERLINK(\"http://x\",\"y\")"), "\"'=HYPERLINK(\"\"http://x\"\",\"\"y\"\")\"");
  EXPECT_EQ(operation_cell("@SUM(1+1)*cmd"), "'@SUM(1+1)*cmd");
  EXPECT_EQ(operation_cell("+cmd|' /C calc'!A0"), "'+cmd|' /C calc'!A0");
  EXPECT_EQ(operation_cell("-2+3"), "'-2+3");
  EXPECT_EQ(operation_cell("\t=1"), "'\t'=1");
  EXPECT_EQ(operation_cell("  \"=1"), "\"'  \"\"=1\"");
  EXPECT_EQ(operation_cell("'=1"), "''=1");
  EXPECT_EQ(operation_cell("\uFF1D1+1"), "'\uFF1D1+1") << "full width";
  EXPECT_EQ(operation_cell("rough;=1+1"), "rough;'=1+1") << "split at semicolons where the comma is the decimal point";
}

TEST(WriteCsv, LeavesOtherTextAndNumbersAsTheyAre) {
  for (const char* name : {"finish", "a=b", "D10-R2", "-12.5", "+3", "3 - rough", "Fr\xC3\xA4sen; fine", "\xFF=1"})
    EXPECT_EQ(operation_cell(name), name);
}

TEST(WriteJunit, ReportsTheSecondsSpent) {
  SmallReport report;
  EXPECT_NE(write_junit(report.model).find("skipped=\"1\" time=\"0.000\""), std::string::npos);
  report.model.seconds = 2;
  const std::string text = write_junit(report.model);
  EXPECT_NE(text.find("skipped=\"1\" time=\"2.000\""), std::string::npos) << text;
  EXPECT_NE(text.find("T1\" time=\"1.500\""), std::string::npos) << "six of eight moves\n" << text;
  EXPECT_NE(text.find("time=\"0.500\""), std::string::npos) << text;
}

TEST(WriteCsv, LeavesABoundThatWasNeverReachedEmpty) {
  SmallReport report;
  report.result.verdicts[5].depth_upper_mm = std::numeric_limits<double>::infinity();
  EXPECT_EQ(lines_of(write_csv(report.model))[6].substr(0, 28), "5,15,feed,1,not-certified,0,");
  EXPECT_EQ(lines_of(write_csv(report.model))[6][28], ',');
}

TEST(WriteCsv, WritesInchesForAnInchPath) {
  SmallReport report;
  report.path.unit = LengthUnit::inch;
  report.result.verdicts[2].depth_mm = 25.4;
  report.result.verdicts[2].witness->point = {50.8, 0, -25.4};
  EXPECT_NE(write_csv(report.model).find("gouge,1,0.01314173228346"), std::string::npos);
  EXPECT_NE(write_csv(report.model).find(",2,0,-1,0,0,1,part.stl"), std::string::npos);
}

TEST(WriteJunit, ShowsWarningsBesideTheTests) {
  SmallReport report;
  const std::string text = write_junit(report.model);
  EXPECT_NE(text.find("<system-out>path.apt:4: warning: word not understood [apt-word]\n</system-out>"),
            std::string::npos)
      << text;
  report.model.notes.clear();
  EXPECT_EQ(write_junit(report.model).find("system-out"), std::string::npos);
}

TEST(WriteJunit, FailsTheOperationsThatGougeAndSkipsTheOpenOnes) {
  const SmallReport report;
  const std::string text = write_junit(report.model);
  EXPECT_NE(text.find("tests=\"2\" failures=\"1\" errors=\"0\" skipped=\"1\""), std::string::npos);
  EXPECT_NE(text.find("name=\"finish &lt;1&gt;, T1\""), std::string::npos);
  EXPECT_NE(text.find("message=\"gouge 0.333 mm deep at line 12; 2 of 6 moves gouge; tool buried in 1 move\""),
            std::string::npos);
  EXPECT_NE(text.find("<skipped message=\"2 of 2 moves not checked or not certified: arcs, as yet, are not read\"/>"),
            std::string::npos);
}

TEST(Escapes, NeverLetBrokenBytesThrough) {
  EXPECT_EQ(xml_escaped("a<b>&\"'\x01"), "a&lt;b&gt;&amp;&quot;&#39; ");
  EXPECT_EQ(
      valid_utf8("\xC3\xA4 \xFF\xC0\x80\xED\xA0\x80"), "\xC3\xA4 " + [] {
        std::string replaced;
        for (int i = 0; i < 6; ++i) replaced += "\xEF\xBF\xBD";
        return replaced;
      }());
}

TEST(Base64, FollowsTheVectorsOfRfc4648) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

TEST(DepthText, KeepsTwoDigitsOfSmallDepths) {
  EXPECT_EQ(depth_text(0.2134, LengthUnit::mm), "0.213 mm");
  EXPECT_EQ(depth_text(0.00012, LengthUnit::mm), "0.00012 mm");
  EXPECT_EQ(depth_text(0, LengthUnit::mm), "0.000 mm");
  EXPECT_EQ(depth_text(0.00002, LengthUnit::inch), "0.00000079 in");
  EXPECT_EQ(depth_text(3e-15, LengthUnit::inch), "0.0000 in") << "what rounding leaves is no length";
  EXPECT_EQ(depth_text(9e-10, LengthUnit::mm), "0.000 mm");
  EXPECT_EQ(short_length_text(0.01, LengthUnit::mm), "0.01 mm");
  EXPECT_EQ(short_length_text(0.01, LengthUnit::inch), "0.000394 in");
  EXPECT_EQ(short_length_text(0.001, LengthUnit::inch), "0.0000394 in");
  EXPECT_EQ(short_length_text(0, LengthUnit::inch), "0 in");
  EXPECT_EQ(depth_text(12.5, LengthUnit::inch), "0.4921 in");
}

TEST(StickoutText, SaysHowLongAndWhatIsInTheWayOneStepBelow) {
  SmallReport report;
  EXPECT_EQ(stickout_lines(report.model), "");
  report.model.stickout_options = StickoutOptions{1, 100};
  StickoutFacts tool;
  tool.found.now_mm = 40.5;
  tool.found.all = {53, 2, Body::holder};
  tool.found.operations = {{0, {53, 2, Body::holder}}, {1, {40.5, kNone, Body::holder}}};
  report.model.stickouts = {tool};
  EXPECT_EQ(stickout_lines(report.model),
            "stick-out T1: 40.5 mm; 53 mm needed, 12.5 mm longer; at 52 mm the holder gouges, line 12\n"
            "stick-out T1, finish <1>: 53 mm needed, 12.5 mm longer; at 52 mm the holder gouges, line 12\n");
  report.model.stickouts[0].found.operations.clear();
  report.model.stickouts[0].shank_end_mm = 50;
  EXPECT_EQ(
      stickout_lines(report.model),
      "stick-out T1: 40.5 mm; 53 mm needed, 12.5 mm longer; at 52 mm the holder gouges, line 12; flutes and shank "
      "reach 50 mm, so it takes a longer tool\n");
  report.model.stickouts[0].found.all = {std::nullopt, 2, Body::head, MoveState::buried};
  EXPECT_EQ(stickout_lines(report.model),
            "stick-out T1: 40.5 mm; no stick-out up to 140.5 mm is enough: the head is inside a solid, line 12\n");
  report.model.stickouts[0].found.all = {40.5, kNone, Body::holder};
  EXPECT_EQ(stickout_lines(report.model), "stick-out T1: 40.5 mm; long enough\n");
}

TEST(CureText, SaysTheTiltRoundedUpAndTheLiftOrWhyThereIsNone) {
  SmallReport report;
  EXPECT_EQ(cures_of(report.model, 0), nullptr);
  report.model.cure_options = CureOptions();
  report.model.cures = {{0, {0.1, ""}, {2.5, 1, Body::holder, MoveState::gouge}},
                        {1, {std::nullopt, "none there"}, {std::nullopt, 2, Body::head, MoveState::gouge}}};
  EXPECT_EQ(cure_text(report.model, *cures_of(report.model, 0)),
            "a tilt of up to 5.73 deg; a lift of 2.5 mm along the tool axis");
  EXPECT_EQ(cure_text(report.model, *cures_of(report.model, 1)),
            "no tilt (none there); no lift up to 100 mm along the tool axis (the head, line 12)");
  EXPECT_EQ(cures_of(report.model, 2), nullptr);
  EXPECT_NE(findings_text(report.model).find("\n  cured by a tilt of up to 5.73 deg; "), std::string::npos);
}

TEST(SummaryText, SaysWhatIsLeftUncutAndCountsItNotAsMoved) {
  SmallReport report;
  report.add_correction();
  report.model.correction.uncut = {{3, 5, 13, 15, 2, 12.5}};
  EXPECT_NE(summary_text(report.model)
                .find("1 position moved by up to 0.250 mm, 1 inserted, 2 positions and 12.5 mm "
                      "left uncut in 1 stretch"),
            std::string::npos)
      << summary_text(report.model);
  report.model.correction.changes[0].is_uncut = true;
  EXPECT_NE(summary_text(report.model).find("0 positions moved, 1 inserted"), std::string::npos);
}

}  // namespace
}  // namespace gouge

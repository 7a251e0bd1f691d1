#include <gtest/gtest.h>

#include <limits>

#include "lib/base/printable_text.h"
#include "postproc/report/remedies.h"
#include "postproc/report/report_text.h"
#include "postproc/report/stickout_text.h"
#include "postproc/report/tightness.h"
#include "postproc/report/write_report.h"
#include "tests/postproc/report/small_report.h"
#include "tests/support/plain_text.h"

namespace gouge::text_writers_test {
namespace {

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

// The operation's column of the first move.
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
  EXPECT_NE(write_junit(report.model).find("errors=\"1\" skipped=\"0\" time=\"0.000\""), std::string::npos);
  report.model.seconds = 2;
  const std::string text = write_junit(report.model);
  EXPECT_NE(text.find("errors=\"1\" skipped=\"0\" time=\"2.000\""), std::string::npos) << text;
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

TEST(WriteJunit, SkipsAnOperationOfRapidsThatAreLeftOut) {
  SmallReport report;
  for (const std::size_t i : {6U, 7U}) report.result.verdicts[i].reason = {Reason::Kind::rapid_skipped};
  report.result.counts.skipped = 2;
  const std::string text = write_junit(report.model);
  EXPECT_NE(text.find("errors=\"0\" skipped=\"1\""), std::string::npos) << text;
  EXPECT_NE(text.find("<skipped message=\"2 rapids left out as asked\"/>"), std::string::npos) << text;
  EXPECT_NE(text.find("note: 2 rapids left out as asked\n"), std::string::npos) << text;
}

TEST(WriteJunit, FailsTheOperationsThatGougeAndReportsTheOpenOnesAsErrors) {
  const SmallReport report;
  const std::string text = write_junit(report.model);
  EXPECT_NE(text.find("tests=\"2\" failures=\"1\" errors=\"1\" skipped=\"0\""), std::string::npos);
  EXPECT_NE(text.find("name=\"finish &lt;1&gt;, T1\""), std::string::npos);
  EXPECT_NE(text.find("message=\"gouge 0.333 mm deep at line 12; 2 of 6 moves gouge; tool buried in 1 move; "
                      "1 of 6 moves not checked"),
            std::string::npos);
  EXPECT_NE(text.find("<error message=\"2 of 2 moves not checked or not certified: arcs, as yet, are not read\"/>"),
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
  report.model.cures = {{0, {0.1, ""}, {2.5, 1, Body::holder, MoveState::gouge, 2.5}},
                        {1, {std::nullopt, "none there"}, {std::nullopt, 2, Body::head, MoveState::gouge}}};
  EXPECT_EQ(cure_text(report.model, *cures_of(report.model, 0)),
            "a tilt of up to 5.73 deg; a lift of 2.5 mm along the tool axis");
  EXPECT_EQ(cure_text(report.model, *cures_of(report.model, 1)),
            "no tilt (none there); no lift up to 100 mm along the tool axis (the head, line 12)");
  report.model.cures[0].lift.not_free_below_mm = 2.41;
  EXPECT_EQ(cure_text(report.model, *cures_of(report.model, 0)),
            "a tilt of up to 5.73 deg; a lift of 2.5 mm along the tool axis, proved; whether less is enough, from 2.41 "
            "mm on, is not certified");
  report.model.cure_options->has_axes = false;
  EXPECT_TRUE(cure_text(report.model, *cures_of(report.model, 0))
                  .starts_with("a tilt of up to 5.73 deg (the file states no tool axes: 'correct' tilts it only with "
                               "--allow-multax); a lift"));
  report.model.cure_options->has_axes = true;
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
  EXPECT_TRUE(headlines(report.model).now.ends_with("; 1 stretch left uncut")) << headlines(report.model).now;
  report.model.correction.changes[0].strategy = "trim";
  EXPECT_NE(summary_text(report.model).find("0 positions moved, 1 inserted"), std::string::npos);
}

TEST(SummaryText, SaysBesideTheVerdictWhatIsNotCutAnyMore) {
  SmallReport report;
  report.add_correction();
  CorrectionFacts& correction = report.model.correction;
  correction.uncut = {{3, 3, 13, 13, 0, 0.25, Uncut::Kind::hole}, {4, 4, 14, 14, 0, 0.5, Uncut::Kind::hole}};
  correction.rapid_clearance_mm = 2;
  correction.low_rapids = {{1, 11, 0.5}, {2, 12, -0.0054}};
  EXPECT_TRUE(headlines(report.model).now.ends_with("; 2 holes left uncut")) << headlines(report.model).now;
  const std::string text = summary_text(report.model);
  for (const char* note :
       {"note: 2 holes left uncut by up to 0.500 mm\n",
        "note: cuts were moved by up to 0.300 mm: less is cut there than was programmed\n",
        "note: 2 rapids that were written keep less than the clearance of 2 mm: the nearest may touch "
        "by up to 0.0054 mm, a gouge only beyond the tolerance, line 12\n"})
    EXPECT_NE(text.find(note), std::string::npos) << text;
  correction.low_rapids = {{2, 12, -0.0046}};
  EXPECT_NE(summary_text(report.model)
                .find("note: 1 rapid that was written keeps less than the clearance of 2 mm: it may touch by up to "
                      "0.0046 mm, a gouge only beyond the tolerance, line 12\n"),
            std::string::npos);
  correction.low_rapids = {{1, 11, 0.5}};
  EXPECT_NE(summary_text(report.model).find("the clearance of 2 mm: 0.500 mm, line 11\n"), std::string::npos);
  correction.changes.clear();
  EXPECT_EQ(summary_text(report.model).find("cuts were moved"), std::string::npos);
}

TEST(WriteHtml, TablesOfChangesBeginWithTheLargest) {
  SmallReport report;
  report.add_correction();
  CorrectionFacts& correction = report.model.correction;
  correction.changes = {correction.changes[0], correction.changes[0]};
  correction.changes[1].shift_length_mm = 7.125;
  correction.uncut = {{3, 3, 13, 13, 0, 0.25}, {4, 4, 14, 14, 0, 99.5}};
  correction.uncorrected = {{1, 11, 0.5, "the lesser", false}, {2, 12, 0.625, "the deeper", false}};
  const std::string page = write_html(report.model, {});
  const auto place = [&](const char* text) { return page.find(text); };
  EXPECT_LT(place("7.125 mm"), place("0.250 mm<"));
  EXPECT_LT(place(">99.5 mm<"), place(">0.25 mm<"));
  EXPECT_LT(place("the deeper"), place("the lesser"));
}

}  // namespace
}  // namespace gouge::text_writers_test

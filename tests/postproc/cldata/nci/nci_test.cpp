// Meaning of each field of a motion pair of Mastercam NCI.
#include <numbers>

#include "lib/path/run_kind.h"
#include "postproc/cldata/interpreting/reasons.h"
#include "postproc/cldata/parsing/arc_statement.h"
#include "tests/postproc/cldata/cl_files.h"
#include "tests/postproc/cldata/path_of.h"

namespace gouge::nci_test {
namespace {

constexpr double kPi = std::numbers::pi;

std::string pair(const std::string& code, const std::string& fields) { return code + "\n" + fields + "\n"; }

// `middle` between two lines that nobody doubts.
Toolpath with(const std::string& middle) {
  return path_of(pair("0", "0 5. 0. 10. -2. 0") + pair("1", "0 5. 0. 1. 100. 0") + middle +
                 pair("1", "0 9. 9. 9. 100. 0"));
}

bool is_checked(const Move& move) { return move.not_checked_reason.empty(); }

TEST(Nci, ReadsTheLinesOfTheSample) {
  const Toolpath path = path_of(bytes_of(corpus() / "sample.nci"));
  ASSERT_EQ(path.moves.size(), 3u);
  EXPECT_EQ(path.moves[0].kind, MoveKind::rapid);
  EXPECT_EQ(path.moves[1].kind, MoveKind::feed);
  expect_vector(path.moves[2].end.tip, 4.5, 2, 0.5);
  expect_vector(path.moves[2].end.axis, 0, 0, 1);
  EXPECT_EQ(path.moves[2].feed_mm, 200);
  EXPECT_EQ(path.tools[0].number, 3);
  EXPECT_TRUE(path.words_not_understood.empty());
}

TEST(Nci, FeedMinusTwoIsRapidInEveryLine) {
  const Toolpath path = path_of(pair("1", "0 5. 0. 1. -2. 0") + pair("11", "5. 0. 2. 5. 0. 3. -2.") +
                                pair("11", "5. 0. 1. 5. 0. 2. -1."));
  EXPECT_EQ(path.moves[0].kind, MoveKind::rapid);
  EXPECT_EQ(path.moves[1].kind, MoveKind::rapid);
  EXPECT_EQ(path.moves[2].kind, MoveKind::feed);
}

TEST(Nci, FeedMinusTwoIsRapidInAnArcToo) {
  const auto arc = [](const std::string& feed) { return pair("2", "0 0 9. 0. 7. 0. 1. " + feed + " 0"); };
  for (const auto& [feed, is_rapid] : {std::pair("-2.", true), std::pair("100.", false), std::pair("-1.", false)}) {
    const Toolpath path = with(arc(feed));
    ASSERT_EQ(path.moves.size(), 4U);
    EXPECT_EQ(path.moves[2].kind, MoveKind::arc);
    EXPECT_EQ(runs_rapid(path.moves[2]), is_rapid) << feed;
    EXPECT_FALSE(runs_rapid(path.moves[3]));
  }
}

TEST(Nci, CompensationIsModalUntilItIsSwitchedOff) {
  for (const char* on : {"41", "42", "141", "142", "1"}) {
    for (const std::string& off : {pair("1", "40 0 3. 1. -1. 0"), pair("1", "140 0 3. 1. -1. 0"),
                                   pair("1004", "0") + pair("1", "0 0 3. 1. -1. 0")}) {
      SCOPED_TRACE(on + off);
      const Toolpath path = with(pair("1", std::string(on) + " 0 1. 1. -1. 0") + pair("1", "0 0 2. 1. -1. 0") + off);
      ASSERT_EQ(path.moves.size(), 6u);
      EXPECT_TRUE(is_checked(path.moves[1]));
      EXPECT_EQ(path.moves[2].not_checked_reason, Reasons::kCutcom);
      EXPECT_EQ(path.moves[3].not_checked_reason, Reasons::kCutcom);
      EXPECT_EQ(path.moves[4].not_checked_reason, Reasons::kAfterCutcom);
      EXPECT_TRUE(is_checked(path.moves[5]));
    }
  }
}

TEST(Nci, CompensatedPositionsAreCheckedWhereTheUserSaysTheyAreTheCentre) {
  ReadOptions options;
  options.is_cutcom_centre = true;
  const ReadOutcome outcome =
      read_toolpath("a.nci", pair("0", "0 5. 0. 10. -2. 0") + pair("1", "41 5. 0. 1. 100. 0"), options);
  ASSERT_TRUE(outcome.toolpath);
  EXPECT_TRUE(is_checked(outcome.toolpath->moves[1]));
}

TEST(Nci, ArcsSwitchCompensationInEitherField) {
  for (const char* fields : {"41 0 0. 5. 0. 0. 1. 100. 0 0", "0 41 0. 5. 0. 0. 1. 100. 0 0"}) {
    const Toolpath path = with(pair("3", fields));
    EXPECT_EQ(path.moves[2].not_checked_reason, Reasons::kCutcom);
    EXPECT_EQ(path.moves[3].not_checked_reason, Reasons::kCutcom);
  }
}

struct ArcCase {
  const char* code;
  const char* fields;
  Vec3 axis;
  double sweep_rad;
};

TEST(Nci, ArcsRunTheirWayInTheirPlane) {
  const std::string start = pair("0", "0 5. 5. 5. -2. 0");
  const std::vector<ArcCase> cases = {{"3", "0 0 -5. 5. 0. 5. 5. 100. 0 0", Vec3::UnitZ(), kPi},
                                      {"2", "0 0 -5. 5. 0. 5. 5. 100. 0 0", Vec3::UnitZ(), -kPi},
                                      {"3", "0 0 0. 10. 0. 5. 5. 100. 0 0", Vec3::UnitZ(), kPi / 2},
                                      {"2", "0 0 0. 10. 0. 5. 5. 100. 0 0", Vec3::UnitZ(), -1.5 * kPi},
                                      {"2", "0 40 0. 10. 0. 5. 5. 100. 0 0", Vec3::UnitZ(), -1.5 * kPi},
                                      // y to z about +x; the plane before compensation or after it
                                      {"3", "1 0 0. 10. 0. 5. 5. 100. 0 0", Vec3::UnitX(), kPi / 2},
                                      {"3", "0 1 0. 10. 0. 5. 5. 100. 0 0", Vec3::UnitX(), kPi / 2},
                                      {"2", "1 40 0. 10. 0. 5. 5. 100. 0 0", Vec3::UnitX(), -1.5 * kPi},
                                      {"2", "140 1 0. 10. 0. 5. 5. 100. 0 0", Vec3::UnitX(), -1.5 * kPi}};
  for (const ArcCase& c : cases) {
    SCOPED_TRACE(std::string(c.code) + " " + c.fields);
    const Toolpath path = path_of(start + pair(c.code, c.fields));
    ASSERT_EQ(path.moves.size(), 2u);
    ASSERT_EQ(path.moves[1].kind, MoveKind::arc);
    ASSERT_EQ(path.moves[1].curve_kind, CurveKind::arc) << path.moves[1].not_checked_reason;
    const PathArc& arc = path.arcs[0];
    EXPECT_NEAR(arc.sweep_rad, c.sweep_rad, 1e-12);
    expect_vector(arc.axis, c.axis.x(), c.axis.y(), c.axis.z());
  }
}

TEST(Nci, AnArcOfTheYzPlaneEndsAtItsThirdCoordinateInX) {
  const Toolpath path = path_of(pair("0", "0 1. 5. 0. -2. 0") + pair("3", "0 1 0. 5. 0. 0. 3. 100. 0 0"));
  expect_vector(path.moves[1].end.tip, 3, 0, 5);
}

TEST(Nci, AnotherThirdCoordinateMakesAHelix) {
  const Toolpath path = with(pair("3", "0 0 0. 5. 0. 0. -2. 100. 0 0"));
  EXPECT_TRUE(is_checked(path.moves[2]));
  expect_vector(path.moves[2].end.tip, 0, 5, -2);
}

TEST(Nci, TheFullCircleFlagIsHeld) {
  for (const char* flag : {" 1", " 0", ""}) {
    const Toolpath path = with(pair("2", std::string("0 0 5. 0. 0. 0. 1. 100. 0") + flag));
    ASSERT_EQ(path.moves[2].curve_kind, CurveKind::arc) << flag;
    EXPECT_NEAR(path.arcs[0].sweep_rad, -2 * kPi, 1e-12) << flag;
  }
  // Rounding of a thousandth: nearly nothing, unless the flag states otherwise.
  const Toolpath reported = with(pair("3", "0 0 5. .001 0. 0. 1. 100. 0 1"));
  ASSERT_EQ(reported.moves[2].curve_kind, CurveKind::arc);
  EXPECT_NEAR(reported.arcs[0].sweep_rad, 2 * kPi, 1e-3);
  EXPECT_EQ(with(pair("3", "0 0 5. .001 0. 0. 1. 100. 0 0")).moves[2].not_checked_reason, ArcProblems::kTiny);
  EXPECT_EQ(with(pair("3", "0 0 0. 5. 0. 0. 1. 100. 0 1")).moves[2].not_checked_reason, ArcProblems::kAngle);
}

TEST(Nci, ArcsOfTheXzPlaneAreNotCheckedButEndWhereTheySay) {
  for (const char* fields : {"0 2 0. -4. 0. 1. 0. 100. 0 0", "2 40 0. -4. 0. 1. 0. 100. 0 0"}) {
    const Toolpath path = with(pair("3", fields));
    EXPECT_EQ(path.moves[2].not_checked_reason, ArcProblems::kXzPlane);
    expect_vector(path.moves[2].end.tip, 0, 0, -4);
    EXPECT_TRUE(is_checked(path.moves[3]));
    ASSERT_TRUE(path.moves[3].has_start);
  }
}

TEST(Nci, AFiveAxisLineHasItsAxisTowardsTheSecondPoint) {
  for (const double length : {0.5, 1.0, 25.0}) {
    const auto at = [&](double base, double part) { return std::to_string(base + length * part); };
    const Toolpath path =
        path_of(pair("11", "1. 2. 3. " + at(1, 0.6) + " " + at(2, 0) + " " + at(3, 0.8) + " 100. 0 0 0. 1. 0."));
    expect_vector(path.moves[0].end.tip, 1, 2, 3);
    expect_vector(path.moves[0].end.axis, 0.6, 0, 0.8, 1e-5);
  }
}

TEST(Nci, FieldsAfterTheFeedOfAFiveAxisLineMoveNothing) {
  const std::string first = "1. 2. 3. 1.6 2. 3.8 100.";
  for (const char* rest : {"", " 7", " 7 0", " 7 1100", " 7 10 .1 .2 .3"}) {
    const Toolpath path = path_of(pair("11", first + rest));
    EXPECT_TRUE(is_checked(path.moves[0])) << rest;
    expect_vector(path.moves[0].end.axis, 0.6, 0, 0.8);
  }
}

struct UnreadCase {
  const char* code;
  const char* fields;
  const char* word;
  bool may_compensate;
};

TEST(Nci, AMotionThatIsNotUnderstoodIsReportedAndCountedByWhatIsWrong) {
  const std::vector<UnreadCase> cases = {{"11", "1. 2. 3. 1. 2. 3. 100. 0 0", "NCI 11, NO TOOL AXIS", false},
                                         {"11", "1. 2. 3. 1e300 2. 1e300 100. 0 0", "NCI 11, NO TOOL AXIS", false},
                                         {"11", "1. 2. 3. 1. 2. 4. 100. 0 200", "NCI 11, COMP. IN FLAGS", true},
                                         {"11", "1. 2. 3. 1. 2. 4. 100. 0 2000", "NCI 11, COMP. IN FLAGS", true},
                                         {"11", "1. 2. 3. 1. 2. 4. 100. 0 -1", "NCI 11, COMP. IN FLAGS", true},
                                         {"11", "1. 2. 3. 1. 2. 4.", "NCI MOTION, FEW NUMBERS", true},
                                         {"3", "41 41 0. 5. 0. 0. 1. 100. 0 0", "NCI ARC, PLANE OR COMP.", true},
                                         {"3", "1 1 0. 5. 0. 0. 1. 100. 0 0", "NCI ARC, PLANE OR COMP.", true},
                                         {"3", "0 3 0. 5. 0. 0. 1. 100. 0 0", "NCI ARC, PLANE OR COMP.", true},
                                         {"3", "0 0 0. 5. 0. 0. 1. 100. 0 2", "NCI ARC, CIRCLE FLAG", false},
                                         {"3", "0 0 0. 5. 0. 0. 1.", "NCI MOTION, FEW NUMBERS", true},
                                         {"1", "0 5. x 1. 100.", "NCI MOTION, FEW NUMBERS", false},
                                         {"81", "1. 2. 3. 4. 5. 6.", "NCI OTHER CODE", false}};
  for (const UnreadCase& c : cases) {
    SCOPED_TRACE(std::string(c.code) + " " + c.fields);
    const Toolpath path = with(pair(c.code, c.fields) + pair("1", "0 8. 8. 8. 100. 0"));
    ASSERT_EQ(path.moves.size(), 5u);
    EXPECT_TRUE(path.moves[2].not_checked_reason.starts_with(Reasons::kUnread));
    EXPECT_FALSE(is_checked(path.moves[3])) << "its start is not known";
    EXPECT_EQ(is_checked(path.moves[4]), !c.may_compensate);
    EXPECT_TRUE(path.words_not_understood.contains(c.word));
  }
}

TEST(Nci, ACommaIsNoBlank) {
  const Toolpath path = with(pair("1", "0 1,5 2,5 3,5 100. 0"));
  ASSERT_EQ(path.moves.size(), 4u);
  EXPECT_TRUE(path.moves[2].not_checked_reason.starts_with(Reasons::kUnread));
}

TEST(Nci, IsRecognisedBehindHundredsOfParameters) {
  std::string text;
  for (int i = 0; i < 500; ++i) text += pair(std::to_string(10000 + i), "some text, 12");
  EXPECT_EQ(path_of(text + pair("1", "0 1. 2. 3. 100. 0")).dialect, "mastercam-nci");
}

TEST(Nci, AnArcFromAnUnknownPlaceIsNotChecked) {
  const Toolpath path = path_of(pair("3", "0 0 0. 5. 0. 0. 1. 100. 0 0") + pair("1", "0 0 9. 1. 100. 0"));
  EXPECT_EQ(path.moves[0].not_checked_reason, ArcProblems::kStart);
  EXPECT_TRUE(is_checked(path.moves[1]));
}

}  // namespace
}  // namespace gouge::nci_test

#include "postproc/cldata/interpreting/reasons.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/postproc/cldata/path_of.h"

namespace gouge::named_reasons_test {
namespace {

TEST(NamedReasons, ReportTheWordAndTheLine) {
  NamedReasons reasons;
  EXPECT_STREQ(reasons.name("shifted", "trans", 7), "shifted: TRANS in line 7");
  EXPECT_STREQ(reasons.name("shifted", "TRANS"), "shifted: TRANS");
  EXPECT_STREQ(reasons.name("moved", "1.5", 9), "moved: (line of numbers) in line 9");
}

TEST(NamedReasons, OfAWordThatIsRepeatedTheFirstLinesAreReported) {
  NamedReasons reasons;
  for (std::size_t line = 1; line <= NamedReasons::kMaxLines; ++line) {
    EXPECT_EQ(reasons.name("shifted", "TRANS", line), "shifted: TRANS in line " + std::to_string(line));
  }
  EXPECT_STREQ(reasons.name("shifted", "TRANS", 21), "shifted: TRANS");
  EXPECT_STREQ(reasons.name("shifted", "ORIGIN", 22), "shifted: ORIGIN in line 22");
}

std::string reason_after(const std::string& statements) {
  const Toolpath path = path_of("PARTNO A\nCUTTER/10\n" + statements + "\nGOTO/0,0,0\nFINI\n");
  return path.moves.empty() ? std::string() : std::string(path.moves.back().not_checked_reason);
}

// A reason that a whole file may have states which statement is behind it.
TEST(NamedReasons, OfAllThatFollowsAStatement) {
  EXPECT_EQ(reason_after("FOO/1,2,3,4,5,6,7,8,9"),
            "follows a statement that is not understood: it may move or change the tool, or shift what follows: FOO in "
            "line 3");
  EXPECT_EQ(reason_after("TRACUT/LAST"),
            "positions follow a statement that is not understood and may turn or shift them: TRACUT in line 3");
  EXPECT_EQ(reason_after("TRANS/1,2,3"),
            "positions are shifted by a TRANS or ORIGIN that is not applied: TRANS in line 3");
  EXPECT_EQ(reason_after("ROTABL/30"),
            "positions are in a turned setup (ROTABL, ROTATE) that is not applied: ROTABL in line 3");
  EXPECT_EQ(reason_after("TRNTYP/LOCAL"), "positions are not in world coordinates (TRNTYP): TRNTYP in line 3");
  EXPECT_EQ(reason_after("TURRET/1"), "turning and wire tools are not understood: TURRET in line 3");
  EXPECT_EQ(reason_after("MODE/TURN"), "turning and wire tools are not understood: MODE in line 3");
  EXPECT_EQ(reason_after("SPLINE/ON"), "a curve that is not understood: SPLINE in line 3");
  EXPECT_EQ(reason_after("MULTAX/NOMORE"),
            "follows a MULTAX that is not understood: its numbers may be points or tool axes: MULTAX in line 3");
  EXPECT_EQ(reason_after("CSYS/0,1,0,0,1,0,0,0,0,0,1,0"),
            "positions are in a coordinate system (CSYS) that is not applied: CSYS in line 3");
  EXPECT_EQ(reason_after("CYCLE/FOO,1"), "a cycle whose words are not understood: CYCLE in line 3");
}

TEST(NamedReasons, OfAMoveThatIsNotReadTheWord) {
  const Toolpath path = path_of("PARTNO A\nCUTTER/10\nGOTO/0,0,0\nFOO/1,2,3\nGOTO/1,0,0\nFINI\n");
  EXPECT_EQ(path.moves.at(1).not_checked_reason, "a statement that is not understood may have moved the tool: FOO");
}

}  // namespace
}  // namespace gouge::named_reasons_test

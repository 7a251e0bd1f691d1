#include <gtest/gtest.h>

#include "tests/postproc/gcode/heidenhain/klartext.h"

namespace gouge::klartext::klartext_flow_test {
namespace {

const std::string kStart = "L X+0 Y+0 Z+10 R0 FMAX\n";

TEST(KlartextFlow, CallsSubprograms) {
  const Toolpath path = blocks_of(kStart +
                                  "CALL LBL 1\nL X+0\nCALL LBL \"TWO\"\nL Z+50 M30\n"
                                  "LBL 1\nL X+5\nLBL 0\nLBL \"TWO\"\nL Y+7\nCALL LBL 1\nLBL 0\n");
  EXPECT_EQ(tips(path), "(0,0,10) (5,0,10) (0,0,10) (0,7,10) (5,7,10) (5,7,50)");
}

TEST(KlartextFlow, RepeatsSections) {
  EXPECT_EQ(tips(blocks_of(kStart + "LBL 1\nL IX+5\nCALL LBL 1 REP 2\nL Y+1\n")),
            "(0,0,10) (5,0,10) (10,0,10) (15,0,10) (15,1,10)");
  EXPECT_EQ(tips(blocks_of(kStart + "LBL 1\nLBL 2\nL IX+1\nCALL LBL 2 REP 1/1\nL IY+1\nCALL LBL 1 REP1\n")),
            "(0,0,10) (1,0,10) (2,0,10) (2,1,10) (3,1,10) (4,1,10) (4,2,10)");
}

TEST(KlartextFlow, JumpsByConditions) {
  const std::string loop = "Q1 = 0\nLBL 1\nL X+Q1\nQ1 = Q1 + 2\nFN 12: IF +Q1 LT +5 GOTO LBL 1\nL Y+1\n";
  EXPECT_EQ(tips(blocks_of(kStart + loop)), "(0,0,10) (0,0,10) (2,0,10) (4,0,10) (4,1,10)");
  EXPECT_EQ(tips(blocks_of(kStart + "FN 9: IF +1 EQU +1 GOTO LBL \"E\"\nL X+9\nLBL \"E\"\nL Y+1\n")),
            "(0,0,10) (0,1,10)");
  EXPECT_EQ(tips(blocks_of(kStart + "FN 10: IF +1 NE +1 GOTO LBL 5\nFN 11: IF +1 GT +2 GOTO LBL 5\nL X+9\nLBL 5\n")),
            "(0,0,10) (9,0,10)");
}

TEST(KlartextFlow, CalculatesWithParameters) {
  EXPECT_EQ(tips(blocks_of(kStart + "FN 0: Q1 = +5\nFN 1: Q2 = +Q1 + +3\nFN 2: Q3 = +10 - +Q1\nFN 3: Q4 = +Q1 * +2\n"
                                    "FN 4: Q5 = +Q4 DIV +4\nFN 5: Q6 = SQRT +16\nL X+Q2 Y+Q3 Z+Q4\nL X+Q5 Y-Q6\n")),
            "(0,0,10) (8,5,10) (2.5,-4,10)");
}

TEST(KlartextFlow, IsLostByValuesThatAreNotKnown) {
  expect_open(kStart + "L X+Q1\n", "the value of X is not known");
  expect_open(kStart + "FN 18: SYSREAD Q1 = ID270 NR1 IDX1\nL X+Q1\n", "the value of X is not known");
  expect_open(kStart + "FN 9: IF +Q1 EQU +1 GOTO LBL 1\nLBL 1\nL X+1\n", "not known");
  expect_open(kStart + "FN 17: SYSWRITE ID220 NR1 = +5\nL X+1\n", "FN 17");
  expect_open(kStart + "FN 26: TABOPEN\nL X+1\n", "FN of this number");
  expect_open(kStart + "FN 140: ERROR = 1000\nL X+1\n", "FN of this number");
  EXPECT_EQ(count_open(blocks_of(kStart + "FN 14: ERROR = 1000\nFN 16: F-PRINT A / B\nL X+1\n")), 0U);
  EXPECT_EQ(count_open(blocks_of(kStart + "L X+Q1\nL X+1 Y+0 Z+0 FMAX\nL X+3\n")), 2U);  // known again
}

TEST(KlartextFlow, IsLostByLabelsThatAreNotThere) {
  expect_open(kStart + "CALL LBL 7\nL X+1\n", "label 7");
  expect_open(kStart + "LBL 7\nLBL 7\nCALL LBL 7\nL X+1\n", "label 7");
  expect_open(kStart + "CALL LBL 7 REP 2\nLBL 7\nL X+1\n", "before its label");
  expect_open(kStart + "CALL PGM OTHER\nL X+1\n", "CALL");
  expect_open(kStart + "LBL 1\nL X+1\nCALL LBL 1\nLBL 0\n", "without an end");
  expect_open(kStart + "LBL\nL X+1\n", "LBL states no label");
}

TEST(KlartextFlow, EndsEndlessLoops) {
  const Toolpath path = blocks_of(kStart + "LBL 1\nFN 9: IF +0 EQU +0 GOTO LBL 1\nL X+1\n");
  EXPECT_NE(last_reason(path).find("a loop may have no end"), std::string::npos);
}

TEST(KlartextFlow, NeedsTheSwitchOfSkippedBlocks) {
  expect_open(kStart + "/L X+5\nL Y+1\n", "--block-delete");
  GcodeOptions options;
  options.setup.is_block_delete_on = true;
  EXPECT_EQ(tips(blocks_of(kStart + "/L X+5\nL Y+1\n", options)), "(0,0,10) (0,1,10)");
  options.setup.is_block_delete_on = false;
  EXPECT_EQ(tips(blocks_of(kStart + "/L X+5\nL Y+1\n", options)), "(0,0,10) (5,0,10) (5,1,10)");
}

TEST(KlartextFlow, KeepsBlocksAfterComments) {
  // A tilde belongs to a block, never to a comment alone.
  EXPECT_EQ(tips(blocks_of(kStart + "; a comment ~\nL X+5\n* - item ~\nL X+6\n")), "(0,0,10) (5,0,10) (6,0,10)");
  expect_open(kStart + "L X+5 ~\nL X+6\n", "not understood");
}

TEST(KlartextProgram, HasItsBounds) {
  EXPECT_FALSE(outcome_of("L X+1 Y+1 Z+1 FMAX\nL X+2\n").toolpath);
  EXPECT_NE(last_reason(path_of("BEGIN PGM A MM\n" + kStart + "BEGIN PGM B MM\nL X+1\n")).find("within a program"),
            std::string::npos);
  EXPECT_NE(last_reason(path_of("BEGIN PGM A MM\n" + kStart + "END PGM A MM\nBEGIN PGM B MM\nL X+1\n")).find("within"),
            std::string::npos);
  EXPECT_FALSE(outcome_of("BEGIN PGM A\n" + kStart).toolpath);
  EXPECT_FALSE(outcome_of("BEGIN PGM MM\n" + kStart).toolpath);
  const auto is_complete = [](const Toolpath& path) {
    for (const Assumption& fact : path.assumptions)
      if (fact.subject == Subject::completeness) return fact.basis == Basis::derived;
    return false;
  };
  EXPECT_TRUE(is_complete(blocks_of(kStart)));
  EXPECT_FALSE(is_complete(path_of("BEGIN PGM A MM\n" + kStart)));
}

TEST(KlartextProgram, IsRecognised) {
  EXPECT_TRUE(is_gcode("0  BEGIN PGM 12 MM\n1 L X+1\n"));
  EXPECT_TRUE(is_gcode("\xef\xbb\xbf; made by a post\n0 BEGIN PGM A INCH \r\n"));
  EXPECT_FALSE(is_gcode("BEGIN PGM MMX\nL X+1\n"));
}

}  // namespace
}  // namespace gouge::klartext::klartext_flow_test

#include <algorithm>

#include "tests/postproc/gcode/siemens/siemens_program.h"

// Variables, expressions, jumps, loops, repetitions and subprograms.

namespace gouge::siemens_flow_test {
namespace {

using test::expect_at;
using test::kHead;
using test::tip_after;

double x_after(const std::string& blocks) { return tip_after(blocks + "G1 X=R1 F100\n").x(); }

TEST(SiemensFlow, ExpressionsFollowTheRanksOfTheManual) {
  EXPECT_DOUBLE_EQ(x_after("R1=1+2*3-8/4\n"), 5);
  EXPECT_DOUBLE_EQ(x_after("R1=(1+2)*3\n"), 9);
  EXPECT_DOUBLE_EQ(x_after("R1=7 DIV 2 + 7 MOD 2\n"), 4);
  EXPECT_NEAR(x_after("R1=SQRT(16)+POT(3)+ABS(-2)+TRUNC(2.9)+ROUND(2.5)\n"), 4 + 9 + 2 + 2 + 3, 1e-12);
  EXPECT_NEAR(x_after("R1=SIN(30)*COS(60)+ATAN2(1,1)\n"), 45.25, 1e-12);
  EXPECT_DOUBLE_EQ(x_after("R2=3\nR3=2\nR1=R2*R[1+2]\n"), 6);
  EXPECT_DOUBLE_EQ(x_after("R1=-R2\nR1=MAXVAL(3,4)-MINVAL(3,4)\n"), 1);
}

TEST(SiemensFlow, VariablesHaveTypes) {
  expect_at(tip_after("DEF REAL _A1=2.5, WIDE\nDEF INT COUNT\nCOUNT=3\nWIDE=_A1*COUNT\nG1 X=WIDE F100\n"), 7.5, 0, 50);
  const ReadOutcome rounded = test::read_siemens(kHead + "DEF INT COUNT\nCOUNT=2.5\nG1 X=COUNT F100\nM30\n");
  EXPECT_FALSE(test::can_be_clean(rounded));
}

TEST(SiemensFlow, LeadingZerosOfAnRParameterHaveNoMeaning) {
  EXPECT_DOUBLE_EQ(x_after("R1=0\nR01=50\n"), 50);
  EXPECT_DOUBLE_EQ(x_after("R001=7\n"), 7);
  EXPECT_DOUBLE_EQ(x_after("R00=8\nR1=R0\n"), 8);
  EXPECT_DOUBLE_EQ(x_after("R0=9\nR1=R[0]+R000\n"), 18);
  EXPECT_DOUBLE_EQ(x_after("R1=1\nR2=0\nR02=1\nIF R2==1 GOTOF THERE\nR1=2\nTHERE: R3=0\n"), 1);
  EXPECT_DOUBLE_EQ(x_after("R1=0\nFOR R02=1 TO 3\nR1=R1+R2\nENDFOR\n"), 6);
  EXPECT_DOUBLE_EQ(x_after("R10=4\nR1=R010\n"), 4);
  ProgramSetup setup;
  setup.read_beside = [](const std::string& name) -> std::vector<std::string> {
    return name == "L10.SPF" ? std::vector<std::string>{"R01=30\nM17\n"} : std::vector<std::string>{};
  };
  EXPECT_DOUBLE_EQ(tip_after("R1=0\nL10\nG1 X=R1 F100\n", setup).x(), 30);
  const auto moves = test::path_of_siemens(kHead + "R5=-6\nR05=-30\nCYCLE81(50,0,2,R5)\nM30\n").moves;
  EXPECT_TRUE(std::ranges::any_of(moves, [](const auto& move) { return move.end.tip.z() < -29; }));
}

TEST(SiemensFlow, JumpsAndConditions) {
  EXPECT_DOUBLE_EQ(x_after("R1=1\nGOTOF THERE\nR1=2\nTHERE: R2=0\n"), 1);
  EXPECT_DOUBLE_EQ(x_after("R1=0\nBACK: R1=R1+1\nIF R1<5 GOTOB BACK\n"), 5);
  EXPECT_DOUBLE_EQ(x_after("R1=0\nN500 R1=R1+1\nIF (R1<>3) GOTO N500\n"), 3);
  EXPECT_DOUBLE_EQ(x_after("R2=1\nIF R2==1\nR1=10\nELSE\nR1=20\nENDIF\n"), 10);
  EXPECT_DOUBLE_EQ(x_after("R2=2\nIF R2==1\nR1=10\nELSE\nIF R2>5\nR1=1\nELSE\nR1=30\nENDIF\nENDIF\n"), 30);
  EXPECT_DOUBLE_EQ(x_after("R2=2\nR1=4\nIF NOT (R2==2)\nR1=10\nENDIF\n"), 4);
}

TEST(SiemensFlow, ConditionalJumpsOfOneBlockRunInTheirOrder) {
  const std::string ends = "R1=3\nGOTOF OUT\nAA: R1=10\nGOTOF OUT\nBB: R1=20\nOUT: R9=0\n";
  const std::string two = "IF R2==1 GOTOF AA IF R2==2 GOTOF BB\n";
  EXPECT_DOUBLE_EQ(x_after("R2=1\n" + two + ends), 10);
  EXPECT_DOUBLE_EQ(x_after("R2=2\n" + two + ends), 20);
  EXPECT_DOUBLE_EQ(x_after("R2=3\n" + two + ends), 3);
  EXPECT_DOUBLE_EQ(x_after("R2=3\nIF R2==1 GOTOF AA IF R2==2 GOTOF AA IF R2==3 GOTOF BB\n" + ends), 20);
  EXPECT_DOUBLE_EQ(x_after("R2=1\nIF R2==1 GOTOF AA IF R7==2 GOTOF BB\n" + ends), 10);
}

TEST(SiemensFlow, ANameThatHoldsTheWordOfAJumpIsNoJump) {
  EXPECT_DOUBLE_EQ(x_after("DEF INT MYGOTO\nR1=1\nIF R1==0\nIF MYGOTO==1\nR1=2\nENDIF\nELSE\nR1=3\nENDIF\n"), 3);
}

TEST(SiemensFlow, Loops) {
  EXPECT_DOUBLE_EQ(x_after("R1=0\nWHILE R1<7\nR1=R1+2\nENDWHILE\n"), 8);
  EXPECT_DOUBLE_EQ(x_after("R1=0\nFOR R2=1 TO 4\nR1=R1+R2\nENDFOR\n"), 10);
  EXPECT_DOUBLE_EQ(x_after("R1=0\nFOR R2=1 TO 2\nFOR R3=1 TO 3\nR1=R1+1\nENDFOR\nENDFOR\n"), 6);
  EXPECT_DOUBLE_EQ(x_after("R1=9\nFOR R2=3 TO 2\nR1=1\nENDFOR\n"), 9);
  EXPECT_DOUBLE_EQ(x_after("R1=0\nREPEAT\nR1=R1+1\nUNTIL R1>=3\n"), 3);
  EXPECT_DOUBLE_EQ(x_after("R1=0\nLOOP\nR1=R1+1\nIF R1==4 GOTOF OUT\nENDLOOP\nOUT: R2=1\n"), 4);
}

TEST(SiemensFlow, SectionsAreRepeated) {
  EXPECT_DOUBLE_EQ(x_after("R1=0\nHERE: R1=R1+1\nR1=R1+10\nREPEAT HERE P=2\n"), 33);
  EXPECT_DOUBLE_EQ(x_after("R1=0\nHERE: R1=R1+1\nENDLABEL:\nR1=R1+10\nREPEAT HERE P=2\n"), 13);
  EXPECT_DOUBLE_EQ(x_after("R1=0\nHERE: R1=R1+1\nR1=R1+10\nREPEATB HERE P=3\n"), 14);
  EXPECT_DOUBLE_EQ(x_after("R1=0\nHERE: R1=R1+1\nTHERE: R1=R1+10\nR1=R1+100\nREPEAT HERE THERE P=1\n"), 122);
}

TEST(SiemensFlow, SubprogramsBesideTheFileAreRead) {
  ProgramSetup setup;
  setup.read_beside = [](const std::string& name) -> std::vector<std::string> {
    if (name == "L010.SPF") return std::vector<std::string>{"R1=R1+50\nM17\n"};  // zeros are a part of the name
    if (name == "L10.SPF") return std::vector<std::string>{"R1=R1+1\nM17\nR1=100\n"};
    if (name == "GOHOME.SPF" || name == "MYSUB.SPF") return std::vector<std::string>{"G1 X7\nM17\n"};
    if (name == "L31.SPF") return std::vector<std::string>{"%_N_L32_SPF\nG1 X9\nM17\n%_N_L31_SPF\nG1 X8\nM17\n"};
    if (name == "L33.SPF") return std::vector<std::string>{"%_N_L33_SPF\nG1 X6\nM17\n"};
    if (name == "POCKET.SPF") return std::vector<std::string>{"PROC POCKET\nG1 X3\nRET\n"};
    return {};
  };
  EXPECT_DOUBLE_EQ(tip_after("R1=0\nL10 P3\nG1 X=R1 F100\n", setup).x(), 3);
  EXPECT_DOUBLE_EQ(tip_after("R1=0\nL010\nG1 X=R1 F100\n", setup).x(), 50);
  EXPECT_DOUBLE_EQ(tip_after("G1 X1 F100\nPOCKET\n", setup).x(), 3);
  EXPECT_DOUBLE_EQ(tip_after("G1 X1 F100\nL33\n", setup).x(), 6);
  EXPECT_FALSE(test::can_be_clean(test::read_siemens(kHead + "G1 X1 F100\nL31\nM30\n", setup)));
  for (const char* name : {"GOHOME", "MYSUB"})
    EXPECT_DOUBLE_EQ(tip_after(std::string("G1 X1 F100\n") + name + "\n", setup).x(), 7) << name;
  const ReadOutcome archive =
      test::read_siemens("%_N_MAIN_MPF\n" + kHead + "L10\nG1 X1 F100\nM30\n%_N_L10_SPF\nG1 X20\nM17\n", setup);
  EXPECT_FALSE(test::can_be_clean(archive));
  EXPECT_NE(test::reasons_of(archive).find("the file itself holds L10"), std::string::npos)
      << test::reasons_of(archive);
  const ReadOutcome missing = test::read_siemens(kHead + "L11\nG1 X1 F100\nM30\n", setup);
  EXPECT_NE(test::reasons_of(missing).find("L11"), std::string::npos);
  EXPECT_FALSE(test::can_be_clean(missing));
}

TEST(SiemensFlow, ALoopWithoutEndIsEnded) {
  const ReadOutcome outcome = test::read_siemens(kHead + "G1 X1 F100\nHERE: R1=1\nGOTOB HERE\nM30\n");
  EXPECT_NE(test::reasons_of(outcome).find("a loop may have no end"), std::string::npos);
  EXPECT_FALSE(test::can_be_clean(outcome));
}

}  // namespace
}  // namespace gouge::siemens_flow_test

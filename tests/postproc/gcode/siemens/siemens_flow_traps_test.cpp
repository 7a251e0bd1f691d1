#include "tests/postproc/gcode/siemens/siemens_program.h"

// Jumps, structures, programs and variables that a careless reader would misread.

namespace gouge::siemens_flow_traps_test {
namespace {

using test::expect_open;
using test::kHead;

TEST(SiemensFlowTraps, WordsBehindAConditionalJump) {
  const std::string reason = "a jump of IF is followed by words that are not read";
  const std::string end = "\nG1 X1 F100\nAA: X2\nBB: X3";
  for (const char* behind : {"GOTOF BB", "X50", "R2=1", "WAIT", "M0", "GOTOF"})
    expect_open(std::string("R1=0\nIF R1==1 GOTOF AA ") + behind + end, reason);
  expect_open("R1=0\nIF R1==1 GOTOF AA IF R1==0 X5" + end, reason);
  expect_open("R1=0\nIF R1==1 GOTOF AA IF R7==2 GOTOF BB" + end, "a condition whose value is not known");
  expect_open("R1=1\nIF R1==1 GOTOF AA X50" + end, reason);
}

TEST(SiemensFlowTraps, WordsBehindAWordOfAStructure) {
  const auto behind = [](const std::string& word) { return word + " is followed by words that are not read"; };
  for (const char* words : {"X50", "G0 X50", "GOTOF AA", "R1=2", "JUNK"}) {
    const std::string text = std::string(" ") + words + "\n", end = "G1 X1 F100\nAA: X2";
    expect_open("R1=1\nIF R1==1\nELSE" + text + "ENDIF\n" + end, behind("ELSE"));
    expect_open("R1=1\nIF R1==0\nELSE" + text + "ENDIF\n" + end, behind("ELSE"));
    expect_open("R1=1\nIF R1==1\nENDIF" + text + end, behind("ENDIF"));
    expect_open("R1=1\nIF R1==0\nENDIF" + text + end, behind("ENDIF"));
    expect_open("R1=1\nIF R1==1\nELSE\nENDIF" + text + end, behind("ENDIF"));
    expect_open("R1=1\nWHILE R1<3\nR1=R1+1\nENDWHILE" + text + end, behind("ENDWHILE"));
    expect_open("R1=3\nWHILE R1<3\nENDWHILE" + text + end, behind("ENDWHILE"));
    expect_open("FOR R1=1 TO 3\nENDFOR" + text + end, behind("ENDFOR"));
    expect_open("FOR R1=3 TO 1\nENDFOR" + text + end, behind("ENDFOR"));
    expect_open("LOOP\nENDLOOP" + text + end, behind("ENDLOOP"));
    expect_open("R1=1\nREPEAT\nUNTIL R1==1" + text + end, behind("UNTIL"));
    expect_open(std::string("EXTERN L10") + text + end, "EXTERN is followed by text");
  }
}

TEST(SiemensFlowTraps, StructuresWhoseBlocksASwitchLeavesOut) {
  const std::string text = "R1=1\nR2=2\nIF R1==0\nR2=3\n/ELSE\nR2=5\nENDIF\nG1 X=R2 F100\n";
  expect_open(text, "ELSE in line 9 may be left out by a switch");
  expect_open("R1=1\nWHILE R1==0\n/ENDWHILE\nENDWHILE\nG1 X1 F100", "ENDWHILE in line 7 may be left out by a switch");
  ProgramSetup setup;
  setup.is_block_delete_on = true;
  EXPECT_DOUBLE_EQ(test::tip_after(text, setup).x(), 2);
  setup.is_block_delete_on = false;
  EXPECT_DOUBLE_EQ(test::tip_after(text, setup).x(), 5);
}

TEST(SiemensFlowTraps, ProgramsOfTheNameOfACycle) {
  for (const char* file : {"CYCLE81.SPF", "CYCLE81.spf", "CYCLE81.MPF", "cycle81.spf"}) {
    ProgramSetup setup;
    setup.read_beside = [file](const std::string& name) {
      return name == file ? std::vector<std::string>{"G0 X50\nM17\n"} : std::vector<std::string>{};
    };
    expect_open("CYCLE81(10,0,3,-6)\nG1 X1 F100", "may run in place of the cycle", setup);
    expect_open("MCALL CYCLE81(10,0,3,-6)\nG1 X1 F100\nMCALL", "may run in place of the cycle", setup);
    EXPECT_TRUE(test::can_be_clean(test::read_siemens(kHead + "CYCLE82(10,0,3,-6)\nM30\n", setup))) << file;
  }
  const auto read = [](const std::string& wanted, const std::string& call) {
    ProgramSetup setup;
    setup.read_beside = [wanted](const std::string& name) {
      return name == wanted ? std::vector<std::string>{"M17\n"} : std::vector<std::string>{};
    };
    return test::reasons_of(test::read_siemens(kHead + call + "\nG1 X1 F100\nM30\n", setup));
  };
  for (const char* call : {"CYCLE832(0.1,1,1)", "CYCLE800()"}) {
    const std::string name = std::string(call).substr(0, 8);
    EXPECT_NE(read(name + ".SPF", call).find("may run in place"), std::string::npos) << call;
  }
}

TEST(SiemensFlowTraps, ProgramsWhoseNamesDifferByTheirLettersAlone) {
  const auto setup_of = [](const std::string& small) {
    ProgramSetup setup;
    setup.read_beside = [small](const std::string& name) -> std::vector<std::string> {
      if (name == "L10.SPF") return std::vector<std::string>{"G1 X5 F100\nM17\n"};
      return name == "l10.spf" ? std::vector<std::string>{small} : std::vector<std::string>{};
    };
    return setup;
  };
  expect_open("L10\nG1 X1 F100", "several files beside the program are called L10", setup_of("G1 X9 F100\nM17\n"));
  EXPECT_DOUBLE_EQ(test::tip_after("L10\n", setup_of("G1 X5 F100\nM17\n")).x(), 5);
}

TEST(SiemensFlowTraps, VariablesOfAModalCycleThatChange) {
  const std::string reason = "an argument of MCALL CYCLE81, changes in line ";
  const std::string cycle = "R1=-6\nR2=7\nMCALL CYCLE81(10,0,3,";
  for (const char* argument : {"R1", "R01", "R1*1", "R[1]", "(0+R1)"})
    expect_open(cycle + argument + ")\nR1=-30\nG1 X1 F100\nMCALL", reason);
  expect_open(cycle + "R1)\nFOR R1=-6 TO -5\nG1 X1 F100\nENDFOR\nMCALL", reason);
  for (const char* change : {"R2=9", "R1=-6", "X5"})
    EXPECT_TRUE(test::can_be_clean(
        test::read_siemens(kHead + cycle + "R1)\n" + change + "\nG1 X1 F100\nMCALL\nR1=3\nX2\nM30\n")))
        << change;
  EXPECT_TRUE(test::can_be_clean(
      test::read_siemens(kHead + cycle + "R1)\nX1\nR1=-7\nMCALL CYCLE81(10,0,3,R1)\nX2\nMCALL\nM30\n")));
}

}  // namespace
}  // namespace gouge::siemens_flow_traps_test

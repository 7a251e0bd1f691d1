// Motions of a file that do not run: those of other programs leave open whether the file is whole, others do not.
#include <algorithm>
#include <string>
#include <vector>

#include "tests/postproc/gcode/program.h"

namespace gouge::other_program_test {
namespace {

using test::read_program;
using test::reasons_of;

const std::string kBlocks =
    "G21 G90 G17 G40 G49 G80 G94\nT1 M6\nG54\nG0 X20. Y20.\nG43 H1 Z120.\nG1 Z0. F250.\nG0 Z120.\n";

Assumption completeness_of(const std::string& text, const std::string& control) {
  ProgramSetup setup;
  setup.are_joint_rapids_straight = true;
  const ReadOutcome outcome = read_program(text, control, setup);
  EXPECT_TRUE(outcome.toolpath) << text << reasons_of(outcome);
  if (!outcome.toolpath) return {};
  EXPECT_TRUE(outcome.toolpath->words_not_understood.empty()) << text << reasons_of(outcome);
  const Assumptions& facts = outcome.toolpath->assumptions;
  const auto found = std::ranges::find(facts, Subject::completeness, &Assumption::subject);
  return found == facts.end() ? Assumption{} : *found;
}

void expect_other(const std::string& text, const std::string& control, std::size_t line, const std::string& evidence) {
  const Assumption fact = completeness_of(text, control);
  EXPECT_EQ(fact.basis, Basis::unknown) << control << "\n" << text;
  EXPECT_EQ(fact.line, line) << control << "\n" << text;
  EXPECT_NE(fact.evidence.find(evidence), std::string::npos) << fact.evidence;
  EXPECT_NE(fact.remedy.find("split the file"), std::string::npos) << fact.remedy;
}

void expect_whole(const std::string& text, const std::string& control) {
  const Assumption fact = completeness_of(text, control);
  EXPECT_EQ(fact.basis, Basis::by_default) << control << "\n" << text << "\n" << fact.evidence;  // of the approach
}

TEST(OtherProgram, AProgramBehindTheFirstOneIsOpen) {
  const std::string first = "%\nO1000\n" + kBlocks;
  for (const char* control : {"haas", "fanuc"}) {
    expect_other(first + "M30\nO2000\n" + kBlocks + "Z-5.\nM30\n%\n", control, 11, "O2000, which ends with M30");
    expect_other(first + "M30\n:2000\n" + kBlocks + "M2\n%\n", control, 11, ":2000, which ends with M2");
    expect_other(first + "M30\nO2000\n" + kBlocks + "%\n", control, 11, "O2000");
    expect_other(first + "M30\nO2000\nM98 P3000\nM30\nO3000\nG1 Z-5.\nM99\n%\n", control, 11, "O2000");
    expect_other(first + "M30\nO2000\nM99\nO3000\nX0.\nM30\n%\n", control, 13, "O3000");
  }
}

TEST(OtherProgram, BlocksBehindThePercentSignAreOpen) {
  for (const char* control : {"haas", "fanuc", "linuxcnc"}) {
    expect_other("%\n" + kBlocks + "M30\n%\n" + kBlocks + "Z-5.\nM30\n%\n", control, 14, "percent sign");
    expect_other("%\n" + kBlocks + "%\nG1 Z-5.\n", control, 10, "percent sign");
    expect_whole("%\n" + kBlocks + "M30\n%\n(X1. Y2.)\nEND OF FILE\n", control);
  }
  expect_other("%\nO1\n" + kBlocks + "M30\n%\n%\nO2\n" + kBlocks + "M99\n%\n", "haas", 13, "program O2");
}

TEST(OtherProgram, BlocksBehindTheEndAreOpen) {
  for (const char* control : {"haas", "fanuc", "linuxcnc", "siemens"}) {
    const bool is_siemens = std::string(control) == "siemens";
    const std::string blocks =
        is_siemens ? "G71 G90 G17 G40 G60 G94 G54\nT1 M6\nD1\nG0 X20 Y20\nZ120\nG1 Z0 F250\nG0 Z120\n" : kBlocks;
    expect_other(blocks + "M30\n" + blocks + "Z-5.\nM30\n", control, 12, "behind the end of the program");
    expect_other(blocks + "M30\nG1 Z-5.\n", control, 9, "behind the end of the program");
    expect_whole(blocks + "M30\nM30\n", control);
  }
}

TEST(OtherProgram, SubprogramsThatNothingCallsAreUsual) {
  for (const char* control : {"haas", "fanuc"}) {
    expect_whole("O1000\n" + kBlocks + "M30\nO2000\nG1 Z-5.\nM99\n", control);
    expect_whole("O1000\n" + kBlocks + "M30\nN100 G1 Z-5.\nM99\n", control);
    expect_whole("O1000\n" + kBlocks + "M30\nO2000\nIF [#1 EQ 1] GOTO 9\nM30\nN9 G1 Z-5.\nM99\n", control);
  }
  expect_whole(kBlocks + "M2\no100 sub\nG1 Z-5.\no100 endsub\n", "linuxcnc");
}

TEST(OtherProgram, CalledProgramsAndJumpsAreOfTheProgram) {
  for (const char* control : {"haas", "fanuc"}) {
    expect_whole("O1000\n" + kBlocks + "M98 P2000\nM30\nO2000\nG1 Z5.\nM99\n", control);
    expect_whole("O1000\n" + kBlocks + "GOTO 9\nG1 Z-5.\nM30\nN9 G0 Z150.\nM30\n", control);
    expect_whole("O1000\n#1=0\n" + kBlocks + "IF [#1 EQ 1] GOTO 9\nM30\nN9 G1 Z-5.\nM30\n", control);
  }
  expect_whole(kBlocks + "o1 if [1 EQ 1]\nM2\no1 endif\nG1 Z-5.\nM2\n", "linuxcnc");
  expect_whole(
      "G71 G90 G17 G40 G60 G94 G54\nR1=0\nT1 M6\nD1\nG0 X20 Y20\nZ120\nG1 Z0 F250\nIF R1==1 GOTOF A\nM30\nA: "
      "Z-5\nM30\n",
      "siemens");
}

TEST(OtherProgram, LinesOfHeidenhainBehindTheEndAreOpenBeforeALabel) {
  const std::string blocks =
      "BEGIN PGM N MM\nTOOL CALL 1 Z S3000\nL X-20 Y30 R0 FMAX\nL Z+50 FMAX\nL X+120 F500\nL R0 FMAX M30\n";
  expect_other(blocks + "L Z-5\nEND PGM N MM\n", "heidenhain", 7, "behind the end of the program");
  expect_other(blocks + "END PGM N MM\nL IZ-5\n", "heidenhain", 8, "behind the end of the program");
  expect_whole(blocks + "LBL 1\nL Z-5\nLBL 0\nEND PGM N MM\n", "heidenhain");
  expect_whole(blocks + "L R0 FMAX\nEND PGM N MM\n", "heidenhain");
}

}  // namespace
}  // namespace gouge::other_program_test

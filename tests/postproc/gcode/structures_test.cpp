#include "tests/postproc/gcode/siemens/siemens_program.h"

// Programs of which a part is lost: loops, conditions and subprograms without their other end.

namespace gouge::test::structures_test {
namespace {

std::string iso(const std::string& blocks) {
  return "G17 G21 G90 G94 G40 G49 G80 G98\nT1 M6\nG43 H1 G0 X0. Y0.\nZ80.\n" + blocks;
}

std::string linuxcnc(const std::string& blocks) { return "G17 G21 G90 G94\nG0 X0 Y0 Z10\nF100\n" + blocks; }

ProgramSetup beside(const std::string& text) {
  ProgramSetup setup;
  setup.read_beside = [text](const std::string& name) {
    const bool is_it = name == "O2000" || name == "L10.SPF" || name == "2000.ngc";
    return is_it ? std::vector{text} : std::vector<std::string>{};
  };
  return setup;
}

TEST(Structures, OfFanucAndHaasMustBeNested) {
  for (const char* control : {"fanuc", "haas"}) {
    expect_checked(iso("#1=0\nWHILE [#1 LT 2] DO1\n#1=#1+1\nEND1\nG1 X1. F9.\nM30\n"), control);
    expect_checked(iso("#1=0\nWHILE [#1 LT 2] DO1\n#2=0\nWHILE [#2 LT 2] DO2\n#2=#2+1\nEND2\n#1=#1+1\nEND1\n"
                       "WHILE [#1 LT 1] DO1\nEND1\nG1 X1. F9.\nM30\n"),
                   control);
    expect_open(iso("#1=0\nWHILE [#1 LT 2] DO1\n#1=#1+1\nG1 X1. F9.\nM30\n"), control, "DO1 in line 6 has no end");
    expect_open(iso("#1=0\nWHILE [#1 LT 2] DO1\nWHILE [#1 LT 2] DO2\n#1=#1+1\nEND1\nEND2\nM30\n"), control,
                "END1 in line 9 stands before the end of");
    expect_open(iso("#1=0\nWHILE [#1 LT 2] DO1\n#1=#1+1\nEND1\nEND1\nG1 X1. F9.\nM30\n"), control,
                "END1 in line 9 has no beginning");
    expect_checked(iso("#1=0\nWHILE [#1 LT 2] DO1\n#1=#1+1\nEND1\nG1 X1. F9.\nM30\nO3000\nEND1\nM99\n"), control);
  }
}

TEST(Structures, AreEnteredAtTheirBeginningAlone) {
  const std::string loop = "WHILE [#1 LT 3] DO1\nN5 #1=#1+1\nEND1\nN9 G1 X1. F9.\nM30\n";
  for (const char* control : {"fanuc", "haas"}) {
    expect_checked(iso("#1=0\nGOTO9\n" + loop), control);
    expect_open(iso("#1=0\nGOTO5\n" + loop), control, "GOTO 5 jumps into a loop");
  }
  const auto siemens = [](const std::string& label) {
    return kHead + "R1=0\nGOTOF " + label + "\nWHILE R1<3\nAA: R1=R1+1\nENDWHILE\nBB: G1 X1 F100\nM30\n";
  };
  expect_open(siemens("AA"), "siemens", "GOTOF AA jumps into a condition or a loop", full_setup());
  EXPECT_EQ(reasons_of(read_program(siemens("BB"), "siemens", full_setup())).find("jumps into"), std::string::npos);
}

TEST(Structures, OfSiemensMustBeNested) {
  const auto expect_lost = [](const std::string& blocks, const std::string& reason) {
    test::expect_open(kHead + blocks + "\nG1 X1 F100\nM30\n", "siemens", reason, full_setup());
  };
  expect_lost("R1=0\nWHILE R1<2\nR1=R1+1", "WHILE in line 6 has no end");
  expect_lost("REPEAT\nR1=1", "REPEAT in line 5 has no end");
  expect_lost("LOOP\nR1=1", "LOOP in line 5 has no end");
  expect_lost("FOR R1=1 TO 3\nR2=1", "FOR in line 5 has no end");
  expect_lost("R1=1\nIF R1==1\nR2=1", "IF in line 6 has no end");
  expect_lost("ELSE", "ELSE in line 5 has no beginning");
  expect_lost("ENDIF", "ENDIF in line 5 has no beginning");
  expect_lost("R1=1\nIF R1==1\nELSE\nELSE\nENDIF", "ELSE in line 8 follows the ELSE in line 7");
  expect_lost("R1=1\nIF R1==1\nWHILE R1<3\nENDIF\nR1=R1+1\nENDWHILE",
              "ENDIF in line 8 stands before the end of WHILE in line 7");
}

TEST(Structures, OfLinuxcncMustBeNested) {
  expect_checked(linuxcnc("o1 if [1 EQ 1]\no2 while [0 EQ 1]\no2 endwhile\no1 else\nG1 X2\no1 endif\nG1 X1\nM2\n"),
                 "linuxcnc");
  expect_checked(linuxcnc("#1=0\no1 do\n#1=[#1+1]\no1 while [#1 LT 2]\nG1 X1\nM2\n"), "linuxcnc");
  expect_open(linuxcnc("o1 endif\nG1 X1\nM2\n"), "linuxcnc", "O1 endif in line 4 has no beginning");
  expect_open(linuxcnc("o1 if [1 EQ 1]\nG1 X1\nM2\n"), "linuxcnc", "O1 if in line 4 has no end");
  expect_open(linuxcnc("o1 if [1 EQ 1]\no2 while [0 EQ 1]\no1 endif\no2 endwhile\nG1 X1\nM2\n"), "linuxcnc",
              "O1 endif in line 6 stands before the end of O2 while in line 5");
  expect_open(linuxcnc("o1 if [1 EQ 1]\no1 else\no1 else\no1 endif\nG1 X1\nM2\n"), "linuxcnc",
              "O1 else in line 6 follows the ELSE in line 5");
}

TEST(Subprograms, WithoutTheirEndAreCutShort) {
  for (const char* control : {"fanuc", "haas"}) {
    expect_checked(iso("M98 P2000\nG1 X1. F9.\nM30\n"), control, beside("O2000\nG1 Z5. F9.\nM99\n"));
    for (const char* cut : {"", "O2000\n", "O2000\nG1 Z5. F9.\n", "O2000\nG1 Z5. F9.\n%\n"})
      expect_open(iso("M98 P2000\nG1 X1. F9.\nM30\n"), control, "ends without M99", beside(cut));
    expect_open(iso("M98 P2000\nG1 X1. F9.\nM30\nO2000\nG1 Z5. F9.\n"), control, "ends without M99");
  }
  expect_open(iso("M97 P50\nG1 X1. F9.\nM30\nN50\nG1 Z5. F9.\n"), "haas", "ends without M99");
  for (const char* cut : {"", "G1 Z5 F100\n", "G1 Z5 F100"}) {
    ProgramSetup setup = full_setup();
    setup.machine = nullptr;
    setup.read_beside = beside(cut).read_beside;
    test::expect_open(kHead + "L10\nG1 X1 F100\nM30\n", "siemens", "ends without M17 or RET", setup);
  }
}

TEST(Subprograms, OfHeidenhainMustEnd) {
  const std::string begin = "BEGIN PGM A MM\nTOOL CALL 1 Z S1000\nL X+0 Y+0 Z+50 R0 FMAX\n";
  const std::string call = "CALL LBL 1\nL Z+4 F100\nM30\nLBL 1\nL Z+5 F100\n";
  ProgramSetup setup;
  setup.tool_length_mm = 100;
  expect_checked(begin + call + "LBL 0\nEND PGM A MM\n", "heidenhain", setup);
  expect_open(begin + call + "END PGM A MM\n", "heidenhain", "ends within the subprogram of label 1", setup);
  for (const char* end : {"END PGM B MM\n", "END PGM A INCH\n"})
    expect_open(begin + "L Z+5 F100\n" + end, "heidenhain", "does not end BEGIN PGM A MM", setup);
}

}  // namespace
}  // namespace gouge::test::structures_test

// Effects of blocks that a reader easily overlooks: none of these programs can be clean, unless the fact is given.
#include "tests/postproc/gcode/program.h"

namespace gouge::test {
namespace {

constexpr const char* kStart = "G17 G21 G90 G94 G40 G49 G80 G98\nT1 M6\nG43 H1 G0 X0. Y0. Z80.\n";

void expect_open(const std::string& text, const std::string& control, const std::string& reason,
                 const ProgramSetup& setup = {}) {
  const ReadOutcome outcome = read_program(text, control, setup);
  EXPECT_FALSE(can_be_clean(outcome)) << text;
  EXPECT_NE(reasons_of(outcome).find(reason), std::string::npos) << text << "\n" << reasons_of(outcome);
}

void expect_checked(const std::string& text, const std::string& control, const ProgramSetup& setup = {}) {
  const ReadOutcome outcome = read_program(text, control, setup);
  EXPECT_TRUE(can_be_clean(outcome)) << text << "\n" << reasons_of(outcome);
}

/// Facts of a machine whose G54 is its zero, with tools of 60 mm and 50 mm.
ProgramSetup measured() {
  ProgramSetup setup;
  setup.offsets["G54"] = {};
  setup.lengths_mm = {{1, 60}, {2, 50}};
  setup.home_mm = Vec3(0, 0, 300);
  return setup;
}

std::string program(const std::string& blocks) { return kStart + blocks + "M30\n"; }

TEST(GcodeEffects, MotionsToTheMachineCancelTheLength) {
  for (const char* block : {"G91 G28 Z0.\nG90\n", "G28 X0. Y0. Z90.\n", "G91 G30 Z0.\nG90\n"}) {
    for (const char* control : {"haas", "fanuc"}) {
      expect_open(program(std::string(block) + "G0 X5.\nG0 Z50.\n"), control, "cancels the tool length", measured());
      const std::string again = program(std::string(block) + "G43 H1\nG0 X5.\nG0 Y0.\nG0 Z50.\nG1 Z40. F9.\n");
      const Toolpath path = path_of_program(again, control, measured());
      EXPECT_EQ(path.moves.back().not_checked_reason, "") << block << " on " << control;
    }
  }
  expect_open(program("G53 Z300.\nG0 Z50.\n"), "fanuc", "G53 in line 4 cancels the tool length", measured());
  expect_checked(program("G53 Z300.\nG0 Z50.\n"), "haas", measured());
  expect_checked(program("G53 X30.\nG0 Z50.\n"), "fanuc", measured());
  expect_checked("G61\n" + program("G91 G28 Z0.\nG90 G0 X5.\nG0 Z50.\n"), "linuxcnc", measured());
}

TEST(GcodeEffects, ALengthThatIsCancelledStaysSoInTheNextTool) {
  expect_open(program("G91 G28 Z0.\nG90 T2 M6\nG0 X5. Y0. Z20.\nG1 X6. F9.\n"), "haas", "cancels the tool length",
              measured());
  expect_checked(program("G91 G28 Z0.\nG90 T2 M6\nG43 H2\nG0 X5. Y0. Z20.\nG1 X6. F9.\n"), "haas", measured());
}

TEST(GcodeEffects, VariablesOfTheControlChangeItsOffsetsAndLengths) {
  for (const char* control : {"haas", "fanuc"}) {
    for (const char* variable : {"#5221", "#2001", "#11001", "#7001", "#1000"})
      expect_open(program(std::string(variable) + "=10.\nG1 X5. F9.\n"), control, std::string(variable) + ",",
                  measured());
    expect_open(program("#100=5221\n#[#100]=10.\nG1 X5. F9.\n"), control, "line 5 is not understood: #5221",
                measured());
    expect_open(program("IF [1 EQ 1] THEN #5221=10.\nG1 X5. F9.\n"), control, "#5221", measured());
    expect_open(program("G1 X#3001 F9.\n"), control, "the value of X", measured());
    expect_checked(program("#999=5.\nG1 X#999 F9.\n"), control, measured());
  }
  expect_open("G61\n" + program("#5241=10\nG1 X5 F9\n"), "linuxcnc", "#5241,", measured());
  expect_checked("G61\n" + program("#5000=5\nG1 X#5000 F9\n"), "linuxcnc", measured());
  ProgramSetup setup = measured();
  setup.start = "#5221=10.\n";
  expect_open(program("G1 X5. F9.\n"), "haas", "set variables", setup);
}

}  // namespace
}  // namespace gouge::test

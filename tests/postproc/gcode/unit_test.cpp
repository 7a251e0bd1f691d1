// Units of the command line against those that programs state.
#include "tests/postproc/gcode/program.h"

namespace gouge::test::unit_test {
namespace {

ReadOutcome read_in(LengthUnit unit, const std::string& text, const std::string& control,
                    const std::string& start = "") {
  ProgramSetup setup;
  setup.control = control;
  setup.start = start;
  return read_gcode("program.nc", SourceText(text), {std::move(setup), unit, {}, ""}, {});
}

std::string iso(const std::string& unit) { return "G61\nG17 G90 " + unit + "\nG0 X1. Y1. Z5.\nG1 Z1. F9.\nM30\n"; }

std::string siemens(const std::string& unit) {
  return "G54 G17 G90 G60 COMPOF " + unit + "\nT1 D1\nG0 X1 Y1 Z5\nG1 Z1 F9\nM30\n";
}

std::string klartext(const std::string& unit) {
  return "0 BEGIN PGM G " + unit +
         "\n1 TOOL CALL 1 Z S800\n2 L X+1 Y+1 Z+5 R0 FMAX M3\n3 L Z+1 F9\n4 M30\n5 END PGM G " + unit + "\n";
}

struct Case {
  const char* control;
  std::string mm, inch;            ///< programs that state these units
  std::string mm_word, inch_word;  ///< the statements
  std::size_t line;                ///< their line
};

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const char* control : {"linuxcnc", "haas", "fanuc"})
    all.push_back({control, iso("G21"), iso("G20"), "G21", "G20", 2});
  all.push_back({"siemens", siemens("G71"), siemens("G70"), "G71", "G70", 1});
  all.push_back({"siemens", siemens("G710"), siemens("G700"), "G710", "G700", 1});
  all.push_back({"heidenhain", klartext("MM"), klartext("INCH"), "BEGIN PGM", "BEGIN PGM", 1});
  return all;
}

void expect_error(const ReadOutcome& outcome, std::size_t line, const std::string& part) {
  ASSERT_FALSE(outcome.toolpath);
  ASSERT_EQ(outcome.errors.size(), 1U);
  EXPECT_EQ(outcome.errors[0].code, "path-unit");
  EXPECT_EQ(outcome.errors[0].line, line);
  EXPECT_NE(outcome.errors[0].message.find(part), std::string::npos) << outcome.errors[0].message;
}

void expect_read(const ReadOutcome& outcome) { EXPECT_TRUE(outcome.toolpath) << reasons_of(outcome); }

TEST(GcodeUnit, OfTheCommandLineMustNotContradictTheProgram) {
  for (const Case& one : cases()) {
    SCOPED_TRACE(std::string(one.control) + " " + one.mm_word);
    expect_error(read_in(LengthUnit::inch, one.mm, one.control), one.line, "states mm (" + one.mm_word + ")");
    expect_error(read_in(LengthUnit::mm, one.inch, one.control), one.line, "states inches (" + one.inch_word + ")");
    expect_read(read_in(LengthUnit::mm, one.mm, one.control));
    expect_read(read_in(LengthUnit::inch, one.inch, one.control));
  }
}

TEST(GcodeUnit, OfTheCommandLineMustNotContradictTheBlocksAtTheStart) {
  expect_error(read_in(LengthUnit::mm, iso(""), "fanuc", "G20"), 0, "in force at the start");
  expect_error(read_in(LengthUnit::inch, siemens(""), "siemens", "G71"), 0, "in force at the start");
  expect_read(read_in(LengthUnit::inch, iso(""), "fanuc", "G20"));
}

TEST(GcodeUnit, OfTheCommandLineHoldsForAProgramThatStatesNone) {
  for (const char* control : {"linuxcnc", "haas", "fanuc", "siemens"}) {
    const std::string text = std::string(control) == "siemens" ? siemens("") : iso("");
    const ReadOutcome outcome = read_in(LengthUnit::inch, text, control);
    ASSERT_TRUE(outcome.toolpath) << reasons_of(outcome);
    EXPECT_EQ(outcome.toolpath->unit, LengthUnit::inch);
    EXPECT_NEAR(outcome.toolpath->moves.back().end.tip.z(), 25.4, 1e-9);
  }
}

TEST(GcodeUnit, OfLengthsBeforeTheStatementIsGivenAtTheStart) {
  const std::string text = "G61 G90\nG0 X1. Y1. Z5.\nG20\nG1 Z1. F9.\nM30\n";
  expect_error(read_in(LengthUnit::mm, text, "fanuc"), 3, "states inches (G20)");
  ProgramSetup setup;
  setup.start = "G21";
  const Toolpath path = path_of_program(text, "fanuc", setup);
  ASSERT_FALSE(path.moves.empty());
  EXPECT_NEAR(path.moves.front().end.tip.z(), 5, 1e-9);
  EXPECT_NEAR(path.moves.back().end.tip.z(), 25.4, 1e-9);
}

}  // namespace
}  // namespace gouge::test::unit_test

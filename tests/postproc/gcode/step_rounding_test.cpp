// A control rounds each incremental word to its increment. Roundings of many words move the tool by more than a check may
// miss.
#include "tests/postproc/gcode/program.h"

namespace gouge::test::step_rounding_test {
namespace {

struct Language {
  const char* control;
  const char* start;
  const char* step;      ///< a format of an incremental word of X
  const char* absolute;  ///< a block with an absolute X
  const char* end;
};

constexpr Language kLanguages[] = {
    {"linuxcnc", "G17 G21 G90 G94 G54\nG0 X0. Y0. Z10.\nF100.\nG91\n", "G1 X", "G90 G1 X5.\nG91\n", "M2\n"},
    {"haas", "G17 G21 G90 G94 G54\nG0 X0. Y0. Z10.\nF100.\nG91\n", "G1 X", "G90 G1 X5.\nG91\n", "M30\n"},
    {"fanuc", "G17 G21 G90 G94 G54\nG0 X0. Y0. Z10.\nF100.\nG91\n", "G1 X", "G90 G1 X5.\nG91\n", "M30\n"},
    {"siemens", "G17 G71 G90 G60 G54 G94 D1\nG0 X0 Y0 Z10\nF100\nG91\n", "G1 X", "G90 G1 X5\nG91\n", "M30\n"},
    {"heidenhain", "BEGIN PGM A MM\nTOOL CALL 1 Z S1000\nL X+0 Y+0 Z+10 R0 FMAX\n", "L IX", "L X+5\n",
     "L Z+10 R0 FMAX M30\nEND PGM A MM\n"}};

ProgramSetup facts() {
  ProgramSetup setup;
  setup.offsets["G54"] = WorkOffset{};
  setup.tool_length_mm = 100;
  setup.are_joint_rapids_straight = true;
  return setup;
}

std::string reasons_after(const Language& language, const std::string& step, int times, const std::string& last = {}) {
  std::string text = language.start;
  for (int i = 0; i < times; ++i) text += language.step + step + "\n";
  return reasons_of(read_program(text + last + language.end, language.control, facts()));
}

bool rounds(const std::string& reasons) { return reasons.find("roundings add up") != std::string::npos; }

TEST(StepRounding, OfManyWordsLosesThePlace) {
  for (const Language& language : kLanguages) {
    const bool is_exact = std::string_view(language.control) == "linuxcnc";
    EXPECT_EQ(rounds(reasons_after(language, "0.01040003", 60)), !is_exact) << language.control;
    EXPECT_FALSE(rounds(reasons_after(language, "0.01040003", 2))) << language.control << ": two words";
    EXPECT_FALSE(rounds(reasons_after(language, "0.013", 500))) << language.control << ": whole increments";
  }
}

TEST(StepRounding, EndsAtAnAbsoluteWord) {
  for (const Language& language : kLanguages) {
    std::string text = language.start;
    for (int i = 0; i < 60; ++i)
      text += std::string(language.step) + "0.01040003\n" + (i % 2 == 1 ? language.absolute : "");
    const std::string reasons = reasons_of(read_program(text + language.end, language.control, facts()));
    EXPECT_FALSE(rounds(reasons)) << language.control << "\n" << reasons;
  }
}

TEST(StepRounding, OfCalculatedValuesCounts) {
  const std::string loop = "#1=0\nWHILE [#1LT100] DO1\n#1=#1+1\nG1 X[1/300]\nEND1\n";
  for (const Language& language : {kLanguages[1], kLanguages[2]}) {
    const std::string text = language.start + loop + language.end;
    EXPECT_TRUE(rounds(reasons_of(read_program(text, language.control, facts())))) << language.control;
  }
  const std::string siemens = "R1=1/300\nG1 X=R1\nX=R1\nX=R1\nX=R1\nX=R1\nX=R1\nX=R1\n";
  EXPECT_TRUE(rounds(reasons_of(read_program(kLanguages[3].start + siemens + "M30\n", "siemens", facts()))));
}

TEST(StepRounding, OfARepeatedCycleCountsForEachHole) {
  const auto drilled = [](const char* control, const char* times) {
    const std::string cycle = "G90\nG1 Z20.\nG91\nG98 G81 X0.0104 Z-5. R-5. " + std::string(times) + "\nG80\n";
    return rounds(reasons_of(read_program(kLanguages[1].start + cycle + "M30\n", control, facts())));
  };
  EXPECT_TRUE(drilled("haas", "L50"));
  EXPECT_TRUE(drilled("fanuc", "K50"));
  EXPECT_FALSE(drilled("haas", "L2"));
}

}  // namespace
}  // namespace gouge::test::step_rounding_test

#include "postproc/cldata/parsing/machine_text.h"

#include <gtest/gtest.h>

#include <string>

namespace gouge {
namespace {

/// The effects of a text as letters: moves, shifts, cycle, steps, tool, offset, unknown.
std::string effects(std::string_view text, bool may_be_name = false) {
  const MachineEffect e = read_machine_text(text, may_be_name);
  std::string letters;
  if (e.moves) letters += 'm';
  if (e.shifts) letters += 's';
  if (e.begins_cycle) letters += 'c';
  if (e.begins_steps) letters += 'i';
  if (e.changes_tool) letters += 't';
  if (e.chooses_offset) letters += 'o';
  if (e.is_unknown) letters += '?';
  return letters;
}

TEST(MachineText, ReportsWhatGCodeDoes) {
  EXPECT_EQ(effects("G0 X1 Y2"), "m");
  EXPECT_EQ(effects("g00z-1"), "m");
  EXPECT_EQ(effects("N10 G90 G54 G0 X0"), "mo");
  EXPECT_EQ(effects("G1 F100"), "");
  EXPECT_EQ(effects("G3 I5."), "m");
  EXPECT_EQ(effects("G92 X0"), "s");
  EXPECT_EQ(effects("G92 S2000"), "");
  EXPECT_EQ(effects("G68.2 X0 Y0 Z0 I0 J30. K0"), "s");
  EXPECT_EQ(effects("G91 G28 Z0 G90"), "m");
  EXPECT_EQ(effects("G91 G28 Z0"), "mi");
  EXPECT_EQ(effects("G81 Z-5. R2. F100"), "mc") << "it drills here, too";
  EXPECT_EQ(effects("T5 M6"), "t");
  EXPECT_EQ(effects("G0 A90."), "ms");
  EXPECT_EQ(effects("G0 A0."), "m");
  EXPECT_EQ(effects("G777"), "?");
}

TEST(MachineText, ReportsWhatOtherControlsDo) {
  EXPECT_EQ(effects("L X+10 R0 FMAX M3"), "m");
  EXPECT_EQ(effects("L M5"), "");
  EXPECT_EQ(effects("CYCL DEF 7.0"), "s");
  EXPECT_EQ(effects("CYCL DEF 247 Q339=+1"), "o");
  EXPECT_EQ(effects("CYCL DEF 200 Q200=2"), "m");
  EXPECT_EQ(effects("CYCL DEF 5000000000"), "m") << "more than an int holds";
  EXPECT_EQ(effects("TOOL CALL 5 Z S2000"), "t");
  EXPECT_EQ(effects("TOOL CALL S3000"), "");
  EXPECT_EQ(effects("ATRANS Z-50"), "s");
  EXPECT_EQ(effects("TRANS"), "s");
  EXPECT_EQ(effects("CYCLE832(0.01,1,1)"), "");
  EXPECT_EQ(effects("POCKET3(50,0,2)"), "m");
  EXPECT_EQ(effects("MYSUB(1,2)"), "?");
  EXPECT_EQ(effects("SPOS=0"), "");
}

TEST(MachineText, TakesSentencesForText) {
  EXPECT_EQ(effects("ROT AND CLAMP THE PART"), "");
  EXPECT_EQ(effects("PUT STOP AT X0 Y0"), "");
  EXPECT_EQ(effects("(G92 Z0)"), "");
  EXPECT_EQ(effects("M8 ; Z-50"), "");
}

TEST(MachineText, TakesNamesOfToolsForNames) {
  for (const char* name : {"D10 R2", "C 12 X 90DEG", "T1 D10 R0.5", "M6 X 1.0 TAP", "SPOT DRILL", "1/4-20 TAP"})
    EXPECT_EQ(effects(name, true), "") << name;
  EXPECT_EQ(effects("G92 Z0", true), "s");
  EXPECT_EQ(effects("Z-50.", true), "m");
}

}  // namespace
}  // namespace gouge

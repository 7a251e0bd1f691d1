// The mutation law's own reader, by itself: an oracle that never objects would prove nothing.
#include "tests/laws/motion_expander.h"

#include <gtest/gtest.h>

#include <ostream>
#include <string>

namespace gouge::laws::motion_expander_test {
namespace {

struct Reading {
  const char* name;
  std::string body;
  std::size_t motions;  // none: a doubt
};

void PrintTo(const Reading& r, std::ostream* out) { *out << r.name; }

class Expanded : public ::testing::TestWithParam<Reading> {};

TEST_P(Expanded, ListsMotionsOrDoubts) {
  const Expansion expansion =
      expand_motions("UNITS/MM\nCUTTER/10\nLOADTL/1\nGOTO/0,0,9\n" + GetParam().body + "FINI\n", "apt");
  EXPECT_EQ(expansion.uncertainties.empty(), GetParam().motions > 0);
  if (expansion.uncertainties.empty()) {
    EXPECT_EQ(expansion.motions.size(), GetParam().motions);
  }
}

const std::string kDrill = "CYCLE/DRILL,FEDTO,5,RAPTO,2\n", kHole = "GOTO/5,0,0\n";

INSTANTIATE_TEST_SUITE_P(
    All, Expanded,
    ::testing::Values(
        Reading{"Plain", "GOTO/1,0,9\n", 2}, Reading{"Continued", "GOTO/1,0,$\n9\n", 2},
        Reading{"ContinuationLost", "GOTO/1,0,9,\n0,0,1\n", 0}, Reading{"WithoutASlash", "GOTO 1,0,9\n", 2},
        Reading{"Glued", "GODLTA-5\n", 2}, Reading{"Misspelt", "GODLT/-5\n", 0},
        Reading{"OfAnotherWord", "MYWORD/1,2\n", 0}, Reading{"OfAnotherWordWithThreeNumbers", "MYWORD/1,2,3\n", 0},
        Reading{"WithinAnotherStatement", "COOLNT/ONGOTO/1,0,9\n", 0}, Reading{"Text", "PPRINT GOTO/1,0,9\n", 1},
        Reading{"LineWithoutAWord", "-5\n", 0}, Reading{"FeedAndSpindle", "FEDRAT/9,MMPM\nSPINDL/5,RPM\n", 1},
        Reading{"Hole", kDrill + kHole + "CYCLE/OFF\n", 6}, Reading{"CycleNeverEnded", kDrill + kHole + kHole, 0},
        Reading{"CycleOffOfNothing", kHole + "CYCLE/OFF\n", 2},
        Reading{"CycleNeverBegun", kDrill + kHole + "CYCLE/OFF\n" + kHole + "CYCLE/OFF\n", 0},
        Reading{"RapidInACycle", kDrill + kHole + "RAPID\n" + kHole + "CYCLE/OFF\n", 0},
        Reading{"HeightTwice", "CYCLE/DRILL,FEDTO,5,FEDTO,1,RAPTO,2\n" + kHole + "CYCLE/OFF\n", 0},
        Reading{"Arc", "CIRCLE/0,5,9,0,0,1,5\nGOTO/5,5,9\n", 2},
        Reading{"ArcTwice", "CIRCLE/0,5,9,0,0,1,5\nCIRCLE/0,5,9,0,0,1,5\nGOTO/5,5,9\n", 0},
        Reading{"ArcWithoutItsEnd", "CIRCLE/0,5,9,0,0,1,5\n", 0},
        Reading{"ArcToElsewhere", "CIRCLE/0,5,9,0,0,1,5\nGOTO/6,5,9\n", 0},
        Reading{"UnitsContradicted", "UNITS/MM,INCHES\n", 0}, Reading{"Shift", "TRANS/0,0,-5\n", 0},
        Reading{"CompensationNeverBegun", "CUTCOM/LEFT\nCUTCOM/OFF\nGOTO/1,0,9\nCUTCOM/OFF\n", 0},
        Reading{"AfterAnAxis", "MULTAX\nGOTO/1,0,9,0,.6,.8\nGOTO/2,0,9\n", 0},
        Reading{"AfterTheEnd", "FINI\nGOTO/1,0,9\n", 2}, Reading{"ToolWithoutACutter", "LOADTL/2\nGOTO/1,0,9\n", 0},
        Reading{"ToolWithACutter", "LOADTL/2\nCUTTER/4\nGOTO/1,0,9\n", 2}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(Expanded, MotionsAreInPartCoordinatesAndMm) {
  const Expansion expansion = expand_motions(
      "TOOL PATH/A,TOOL,B\nTLDATA/MILL,1.0,0.0,5.0,0.0,0.0\nMSYS/1.0,0.0,0.0,0.0,1.0,0.0,-1.0,0.0,0.0\n"
      "FEDRAT/IPM,9.0\nGOTO/1.0,0.0,0.0\nGOTO/2.0,0.0,0.0,1.0,0.0,0.0\nEND-OF-PATH\n",
      "nx-clsf");
  ASSERT_TRUE(expansion.uncertainties.empty());
  ASSERT_EQ(expansion.motions.size(), 2u);
  EXPECT_TRUE(expansion.motions[0].to.tip.isApprox(Vec3(25.4, 25.4, 0)));
  EXPECT_TRUE(expansion.motions[1].to.axis.isApprox(Vec3(0, 1, 0)));
  EXPECT_DOUBLE_EQ(expansion.motions[1].diameter_mm.value_or(0), 25.4);
}

}  // namespace
}  // namespace gouge::laws::motion_expander_test

#include "toolmodels/silhouette.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace gouge::silhouette_test {
namespace {

TEST(Silhouette, ACutterReachesNowhereOutOfItself) {
  const std::vector<Cutter> cutters = {FlatCutter{10, 30},           BallCutter{10, 30},
                                       BullNoseCutter{10, 1, 30},    DrillCutter{10, 118, 40},
                                       ChamferCutter{10, 1, 45, 20}, AptCutter{10, 1, 4, 1, 0, 0, 30}};
  for (const Cutter& cutter : cutters) {
    ASSERT_TRUE(make_cutter_profile(cutter)) << shape_name(cutter);
    EXPECT_LT(reach_beyond_mm(cutter, cutter), 1e-12) << shape_name(cutter);
  }
}

TEST(Silhouette, ReachIsMeasuredUpToTheLowerHeight) {
  const AptCutter cone{10, 0, 5, 0, 0, 20, 28};
  const double slope = std::tan(20 * std::numbers::pi / 180);
  EXPECT_NEAR(reach_beyond_mm(cone, FlatCutter{10, 30}), 28 * slope, 1e-9);
  EXPECT_NEAR(reach_beyond_mm(cone, FlatCutter{10, 12}), 12 * slope, 1e-9);
  EXPECT_EQ(reach_beyond_mm(FlatCutter{10, 30}, cone), 0);
}

TEST(Silhouette, AFlatEndReachesOutOfARoundOne) {
  // At the height of the rounding that counts as the same.
  const double r = std::sqrt(2 * 5 * 1e-3);
  EXPECT_NEAR(reach_beyond_mm(FlatCutter{10, 30}, BallCutter{10, 30}), 5 - r, 2e-3);
  EXPECT_EQ(reach_beyond_mm(BallCutter{10, 30}, FlatCutter{10, 30}), 0);
}

TEST(Silhouette, AWholeToolIsComparedBetweenTwoHeights) {
  ToolAssembly necked;
  necked.cutter = FlatCutter{10, 30};
  necked.shank = {{8, 8, 20}, {10, 10, 20}};
  ToolAssembly plain;
  plain.cutter = FlatCutter{10, 60};
  EXPECT_EQ(reach_beyond_mm(plain, necked, 0, 30), 0);
  EXPECT_NEAR(reach_beyond_mm(plain, necked, 30, 60), 1, 1e-9);
  EXPECT_EQ(reach_beyond_mm(plain, necked, 50, 60), 0);
  EXPECT_EQ(reach_beyond_mm(plain, necked, 60, 50), 0);
  EXPECT_EQ(reach_beyond_mm(necked, plain, 0, 70), 5) << "above the top of the other";
}

TEST(Silhouette, ATipThatTapersInwardReachesOutNextToAStep) {
  ToolAssembly stepped;
  stepped.cutter = FlatCutter{10, 30};
  stepped.shank = {{8, 8, 30}};
  ToolAssembly narrowing;
  narrowing.cutter = TaperedCutter{10.2, 0, -2, 60};
  const double at_step = 5.1 - 30.002 * std::tan(2 * std::numbers::pi / 180);
  EXPECT_NEAR(reach_beyond_mm(narrowing, stepped, 20, 60), at_step - 4, 1e-3);
}

TEST(Silhouette, OfACutterWithoutAProfileIsNone) {
  EXPECT_EQ(reach_beyond_mm(FlatCutter{-1, 30}, FlatCutter{10, 30}), 0);
}

}  // namespace
}  // namespace gouge::silhouette_test

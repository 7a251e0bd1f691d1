#include "lib/tool/free_regions.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "lib/tool/evaluate.h"
#include "tests/support/tools.h"

namespace gouge {
namespace {

TEST(FreeRegions, OfACylinderAreOneStretchOfItsAxis) {
  const CompiledTool tool = tools::flat(10).bare;
  const FreeRegions found = RegionFinder(tool).at(0.01);
  ASSERT_EQ(found.regions.size(), 1U);
  EXPECT_TRUE(found.covers_all());
  EXPECT_LT(found.regions[0].z_lo_mm, 0.5);
  EXPECT_GT(found.regions[0].z_hi_mm, 119.5);
}

TEST(FreeRegions, ANeckThinnerThanTwiceTheDepthSeparates) {
  ToolAssembly tool;
  tool.number = 1;
  tool.cutter = BallCutter{10, 20};
  tool.shank = {{0.6, 0.6, 20}};
  tool.holder = {{30, 30, 40}};
  const CompiledTool compiled = tools::variants(tool).bare;
  const RegionFinder finder(compiled);
  EXPECT_EQ(finder.at(0.29).regions.size(), 1U);
  const FreeRegions parted = finder.at(0.31);
  EXPECT_EQ(parted.regions.size(), 2U);
  EXPECT_FALSE(parted.covers_all());
  EXPECT_EQ(parted.uncovered(), Body::shank);
  EXPECT_FALSE(parted.regions[0].meets(parted.regions[1]));
  EXPECT_TRUE(parted.regions[1].meets(finder.at(0.29).regions[0]));
}

TEST(FreeRegions, TheRingOfAHollowCutterIsJoinedWithItsAxis) {
  const CompiledTool tool = tools::variants(tools::assembly(FaceMillCutter{40, 1, 45, 50, 24, 5, 25}, 6)).bare;
  const RegionFinder finder(tool);
  const auto has_ring = [](const FreeRegions& found) {
    return std::any_of(found.regions.begin(), found.regions.end(),
                       [](const FreeRegion& region) { return region.ring != FreeRegion::kNoRing; });
  };
  EXPECT_FALSE(has_ring(finder.at(0.01))) << "joined with the axis through the cutter's body";
  EXPECT_TRUE(finder.at(0.01).covers_all());
}

TEST(FreeRegions, HoldTheirPlacesDeeperThanAskedInEveryShape) {
  for (const ToolVariants& tool : tools::shapes()) {
    const RegionFinder finder(tool.bare);
    for (const double depth : {0.0, 0.01, 0.5, 2.0}) {
      const FreeRegions found = finder.at(depth);
      for (const FreeRegion& region : found.regions) {
        EXPECT_NEAR(-evaluate(tool.bare, region.deepest.x(), region.deepest.y()).signed_distance_mm, region.depth_mm,
                    1e-9);
        if (region.ring != FreeRegion::kNoRing) continue;
        for (int i = 1; i < 200; ++i) {
          const double z = region.z_lo_mm + (region.z_hi_mm - region.z_lo_mm) * i / 200;
          EXPECT_GT(-evaluate(tool.bare, 0, z).signed_distance_mm, depth) << tool.bare.name << " at " << z;
        }
      }
      if (depth < 0.1) {
        EXPECT_TRUE(found.covers_all()) << tool.bare.name;
      }
    }
  }
}

}  // namespace
}  // namespace gouge

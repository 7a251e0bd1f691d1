#include "lib/tool/free_regions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lib/tool/evaluate.h"
#include "tests/support/tools.h"
#include "toolmodels/compile_tool.h"

namespace gouge::free_regions_test {
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

// The lip between the bottom and the hollow is a cusp. Only tiny steps lead up along it.
TEST(FreeRegions, ALipThatEndsInACuspIsClimbed) {
  Profile profile;
  const Vec2 lip(6.4639254822015815, 0), top(3.323842263050456, 1.7854684753637535);
  const Vec2 middle = 0.5 * (lip + top), along = (top - lip).normalized(), side(along.y(), -along.x());
  const double radius = 3.63, half = 0.5 * (top - lip).norm();
  const Vec2 center = middle + std::sqrt(radius * radius - half * half) * side;
  profile.elements = {make_segment(Body::cutter, {0, 0}, lip), make_concave_arc(Body::cutter, lip, top, center, radius),
                      make_segment(Body::cutter, top, {10.3, 5.9}), make_segment(Body::cutter, {10.3, 5.9}, {0, 5.9})};
  ASSERT_TRUE(verify_profile(profile).empty());
  const CompiledTool tool = compile_tool("lip", profile);
  const FreeRegions found = RegionFinder(tool).at(0.01);
  ASSERT_FALSE(found.regions.empty());
  for (const FreeRegion& region : found.regions) EXPECT_GT(region.depth_mm, 0.01);
}

}  // namespace
}  // namespace gouge::free_regions_test

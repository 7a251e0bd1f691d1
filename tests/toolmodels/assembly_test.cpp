#include "toolmodels/assembly.h"

#include <gtest/gtest.h>

#include "lib/tool/evaluate.h"
#include "tests/toolmodels/sample_tools.h"
#include "toolmodels/compile_tool.h"

namespace gouge::assembly_test {
namespace {

ToolAssembly held() {
  ToolAssembly tool;
  tool.number = 7;
  tool.cutter = FlatCutter{10, 30};
  tool.shank = {{8, 8, 10}, {12, 16, 40}};
  tool.extensions = {{"arbor", Body::shank, {{20, 20, 25}}}, {"collet", Body::holder, {{28, 24, 15}}}};
  tool.holder = {{40, 50, 20}, {30, 30, 10}};
  return tool;
}

std::string error_of(const ToolAssembly& tool) {
  const Result<Profile> profile = make_profile(tool);
  return profile ? "none" : profile.error().message + " [" + profile.error().code + "]";
}

TEST(Assembly, BodiesStandOnOneAnother) {
  const std::vector<PositionedSegment> placed = position_segments(held());
  ASSERT_EQ(placed.size(), 6u);
  EXPECT_EQ(placed[1].name, "shank 2");
  EXPECT_EQ(placed[2].name, "arbor 1");
  EXPECT_EQ(placed[2].body, Body::shank);
  EXPECT_EQ(placed[2].z_mm, 80);
  EXPECT_EQ(placed[3].body, Body::holder);
  EXPECT_EQ(height_mm(held()), 150);
  EXPECT_EQ(stickout_mm(held()), 80) << "tip to the lowest that holds";
  const Result<BodyProfiles> bodies = make_body_profiles(held());
  EXPECT_EQ((*bodies)[1].elements.back().b.y(), 105);
  EXPECT_EQ((*bodies)[2].elements.front().a.y(), 105);
  EXPECT_TRUE(make_profile(held()).has_value());
}

TEST(Assembly, StickoutPutsTheRestOfTheShankIntoTheHolder) {
  ToolAssembly tool = held();
  tool.stickout_mm = 60;
  const std::vector<PositionedSegment> placed = position_segments(tool);
  EXPECT_EQ(placed[1].segment.length_mm, 20);
  EXPECT_EQ(placed[1].segment.upper_diameter_mm, 14) << "half of the cone from 12 to 16";
  EXPECT_EQ(placed[2].z_mm, 60);
  EXPECT_EQ(height_mm(tool), 130);
  tool.stickout_mm = 40;
  EXPECT_EQ(position_segments(tool).size(), 5u) << "the second segment is wholly inside";
  tool.extensions.clear();
  tool.holder.clear();
  EXPECT_EQ(height_mm(tool), 80) << "nothing holds it, so nothing is left out";
}

TEST(Assembly, MistakesNameTheFieldAndWhatIsAllowed) {
  ToolAssembly tool = held();
  tool.stickout_mm = 20;
  EXPECT_EQ(error_of(tool),
            "tool T7: stickout 20 mm is less than the length of the flutes, 30 mm: the holder would swallow the "
            "cutter; give at least that [tool-stickout]");
  tool.stickout_mm = 90;
  EXPECT_EQ(error_of(tool),
            "tool T7: stickout 90 mm is more than flutes and shank reach, 80 mm; give at most that, or a longer shank "
            "[tool-stickout]");
  tool.stickout_mm = -1;
  EXPECT_EQ(error_of(tool), "tool T7: stickout is -1 mm; it must not be negative [tool-dimension-negative]");
  tool = held();
  std::swap(tool.extensions[0], tool.extensions[1]);
  EXPECT_EQ(error_of(tool),
            "tool T7: extension \"arbor\": counts as shank, but stands on one that counts as holder; let this one "
            "count as holder too [tool-extension]");
  tool = held();
  tool.extensions[1].segments[0].length_mm = 0;
  EXPECT_EQ(error_of(tool),
            "tool T7: extension \"collet\" 1: length is 0 mm; it must be greater than 0 [tool-dimension-not-positive]");
}

// A point of the scene that is no farther from the tip than `reach` sees the tool that goes on forever.
TEST(Assembly, ALongerStickoutRaisesWhatHoldsAndLengthensTheShankWhereItMust) {
  const ToolAssembly tool = held();
  for (const double by : {0.0, 5.0, 25.0}) {
    const ToolAssembly longer = with_longer_stickout(tool, by);
    ASSERT_EQ(error_of(longer), "none");
    EXPECT_DOUBLE_EQ(stickout_mm(longer), 80 + by);
    EXPECT_DOUBLE_EQ(height_mm(longer), 150 + by);
    EXPECT_DOUBLE_EQ(shank_end_mm(longer), 80 + by) << "the shank went on, as wide as it ended";
    EXPECT_EQ(longer.shank.size(), by > 0 ? 3U : 2U);
  }
  ToolAssembly stated = tool;
  stated.stickout_mm = 60;
  stated.gauge_length_mm = 130;
  const ToolAssembly within = with_longer_stickout(stated, 12);
  ASSERT_EQ(error_of(within), "none");
  EXPECT_DOUBLE_EQ(stickout_mm(within), 72);
  EXPECT_DOUBLE_EQ(shank_end_mm(within), 80) << "the shank in the holder comes out";
  EXPECT_DOUBLE_EQ(within.gauge_length_mm, 142);
  const ToolAssembly beyond = with_longer_stickout(stated, 33);
  ASSERT_EQ(error_of(beyond), "none");
  EXPECT_DOUBLE_EQ(stickout_mm(beyond), 93);
  EXPECT_DOUBLE_EQ(shank_end_mm(beyond), 93);
}

TEST(Assembly, ALongerToolOfFlutesAloneGetsAShank) {
  ToolAssembly flutes;
  flutes.cutter = FlatCutter{10, 30};
  const ToolAssembly longer = with_longer_stickout(flutes, 7);
  ASSERT_EQ(error_of(longer), "none");
  ASSERT_EQ(longer.shank.size(), 1U);
  EXPECT_DOUBLE_EQ(longer.shank[0].upper_diameter_mm, 10);
  EXPECT_DOUBLE_EQ(height_mm(longer), 37);
}

TEST(Assembly, WhatDoesNotCutIsTheToolWithoutItsCutter) {
  const ToolVariants bodies = *make_non_cutting_variants(held(), 0, 0);
  EXPECT_DOUBLE_EQ(bodies.bare.z_min_mm, 30);
  EXPECT_DOUBLE_EQ(bodies.bare.z_max_mm, 150);
  for (const BoundaryElement& element : bodies.bare.elements) EXPECT_NE(element.body, Body::cutter);
  ToolAssembly flutes;
  flutes.cutter = FlatCutter{10, 30};
  EXPECT_TRUE(make_non_cutting_variants(flutes, 0, 0)->bare.elements.empty());
}

TEST(Assembly, ExtendedUpAToolOfFlutesAloneIsACutterAllTheWay) {
  for (const Cutter& cutter :
       {Cutter(FlatCutter{10, 30}), Cutter(BallCutter{8, 4}), Cutter(TaperedCutter{6, 1, 5, 20})}) {
    ToolAssembly flutes;
    flutes.cutter = cutter;
    const ToolAssembly longer = extended_up(flutes, 200);
    ASSERT_EQ(error_of(longer), "none");
    EXPECT_DOUBLE_EQ(height_mm(longer), 200);
    const BodyProfiles bodies = *make_body_profiles(longer);
    EXPECT_TRUE(verify_profile(bodies[0]).empty());
    EXPECT_TRUE(bodies[1].elements.empty() && bodies[2].elements.empty());
    EXPECT_DOUBLE_EQ(bodies[0].elements.back().a.y(), 200);
    EXPECT_DOUBLE_EQ(bodies[0].elements.back().a.x(), make_body_profiles(flutes)->at(0).elements.back().a.x());
  }
}

TEST(Assembly, ExtendedUpIsAsIfItHadNoEnd) {
  test::Scatter random(5);
  std::vector<ToolAssembly> tools = test::sample_tools();
  tools.push_back(held());
  for (const ToolAssembly& tool : tools) {
    const double reach = random.in(10, 300), widest = 40;
    const ToolAssembly longer = extended_up(tool, reach + widest), longest = extended_up(tool, 20 * reach + 1000);
    EXPECT_GE(height_mm(longer), reach + widest);
    const CompiledTool one = compile_tool("", *make_profile(longer)), other = compile_tool("", *make_profile(longest));
    for (int k = 0; k < 2000; ++k) {
      const double z = random.in(-reach, reach), r = random.in(0, reach);
      if (r * r + z * z > reach * reach) continue;
      const double a = evaluate(one, r, z).signed_distance_mm, b = evaluate(other, r, z).signed_distance_mm;
      ASSERT_NEAR(a, b, 1e-9) << tool.name << " " << r << " " << z;
    }
  }
  EXPECT_EQ(height_mm(extended_up(held(), 10)), 150) << "high enough already";
}

}  // namespace
}  // namespace gouge::assembly_test

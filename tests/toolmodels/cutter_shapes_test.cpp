#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lib/tool/evaluate.h"
#include "tests/support/verify_tool.h"
#include "toolmodels/compile_tool.h"
#include "toolmodels/cutter.h"

// Every shape at points a reader can check with a pocket calculator, and every mistake by its words.

namespace gouge::cutter_shapes_test {
namespace {

std::string error_of(const Cutter& cutter) {
  const Result<Profile> profile = make_cutter_profile(cutter);
  return profile ? "none" : profile.error().message + " [" + profile.error().code + "]";
}

Profile profile_of(const Cutter& cutter) {
  const Result<Profile> profile = make_cutter_profile(cutter);
  EXPECT_TRUE(profile.has_value()) << (profile ? "" : profile.error().message);
  return profile ? *profile : Profile{};
}

// Starts of the elements, then the last end; to 1e-9.
void expect_points(const Cutter& cutter, const std::vector<Vec2>& expected) {
  const Profile profile = profile_of(cutter);
  ASSERT_EQ(profile.elements.size() + 1, expected.size());
  for (std::size_t i = 0; i < profile.elements.size(); ++i)
    EXPECT_NEAR((profile.elements[i].a - expected[i]).norm(), 0, 1e-9)
        << i << ": " << profile.elements[i].a.transpose();
  EXPECT_NEAR((profile.elements.back().b - expected.back()).norm(), 0, 1e-9);
}

double depth(const Cutter& cutter, double r, double z) {
  const CompiledTool tool = compile_tool("", profile_of(cutter));
  EXPECT_EQ(test::verify_tool(tool), std::vector<std::string>{});
  return -evaluate(tool, r, z).signed_distance_mm;
}

TEST(Shapes, EveryShapeHasANameOfItsOwn) {
  std::vector<std::string> names;
  for (const Cutter& shape : every_shape()) {
    EXPECT_EQ(std::count(names.begin(), names.end(), shape_name(shape)), 0);
    names.emplace_back(shape_name(shape));
  }
  EXPECT_EQ(names.size(), 17u);
}

TEST(Shapes, DrillHasItsPoint) {
  const double h = 5 / std::tan(59 * std::numbers::pi / 180);
  expect_points(DrillCutter{10, 118, 40}, {{0, 0}, {5, h}, {5, 40}, {0, 40}});
  expect_points(DrillCutter{10, 180, 40}, {{0, 0}, {5, 0}, {5, 40}, {0, 40}});
  EXPECT_EQ(error_of(DrillCutter{10, 0, 40}),
            "point_angle is 0 degrees; the included angle of the point must lie above 0 and be 180 at most "
            "[tool-angle-out-of-range]");
  EXPECT_EQ(
      error_of(DrillCutter{10, 90, 4}),
      "length 4 mm ends within the point, which reaches up to z = 5 mm; give a greater length [tool-length-too-short]");
}

TEST(Shapes, ChamferMayBePointedAndNeedsNoStraightPart) {
  expect_points(ChamferCutter{12, 2, 45, 8}, {{0, 0}, {1, 0}, {6, 5}, {6, 8}, {0, 8}});
  expect_points(ChamferCutter{12, 0, 45, 0}, {{0, 0}, {6, 6}, {0, 6}});
  EXPECT_NEAR(length_mm(ChamferCutter{12, 0, 45, 0}), 6, 1e-12);
  EXPECT_NEAR(depth(ChamferCutter{12, 0, 45, 0}, 0, 2), std::sqrt(2), 1e-12);
  EXPECT_EQ(error_of(ChamferCutter{12, 12, 45, 8}),
            "tip_diameter 12 mm is not less than diameter 12 mm, which is the largest [tool-dimensions-contradict]");
  EXPECT_EQ(
      error_of(ChamferCutter{12, 2, 45, 4}),
      "length 4 mm ends within the cone, which reaches up to z = 5 mm; give a greater length [tool-length-too-short]");
  EXPECT_EQ(error_of(ChamferCutter{12, -1, 45, 4}),
            "tip_diameter is -1 mm; it must not be negative [tool-dimension-negative]");
  EXPECT_EQ(error_of(ChamferCutter{12, 1, 90, 4}),
            "taper_angle is 90 degrees; it must lie between 0 and 90 [tool-angle-out-of-range]");
}

TEST(Shapes, AptMayBeHollowOrPointed) {
  const double low = -10 * std::tan(20 * std::numbers::pi / 180);
  expect_points(AptCutter{20, 0, 0, 0, -20, 0, 15}, {{0, 0}, {10, low}, {10, 15}, {0, 15}});
  const Profile rounded = profile_of(AptCutter{20, 2, 0, 0, -20, 0, 15});
  ASSERT_EQ(rounded.elements.size(), 4u);
  EXPECT_NEAR(rounded.elements[1].center.x(), 8, 1e-12);
  const CompiledTool tool = compile_tool("", rounded);
  EXPECT_NEAR(tool.z_min_mm, rounded.elements[1].center.y() - 2, 1e-12) << "below both ends of the arc";
  EXPECT_GT(evaluate(tool, 0, -0.5).signed_distance_mm, 0) << "the hollow is free";
  expect_points(AptCutter{0, 0, 0, 0, 0, 45, 10}, {{0, 0}, {10, 10}, {0, 10}});
  expect_points(AptCutter{10, 0, 0, 0, 45, 0, 5}, {{0, 0}, {5, 5}, {0, 5}});
  EXPECT_EQ(error_of(AptCutter{20, 0, 0, 0, -90, 0, 15}),
            "alpha is -90 degrees; it must lie between -90 and 90 [tool-angle-out-of-range]");
  EXPECT_EQ(error_of(AptCutter{20, 0, 0, 0, -30, -60, 15}),
            "beta is -60 degrees; it must lie between -60 and 90 for alpha -30 [tool-angle-out-of-range]");
}

TEST(Shapes, LollipopEndsAtItsNeckOrItsLength) {
  expect_points(LollipopCutter{10, 6, 0}, {{0, 0}, {3, 9}, {0, 9}});
  expect_points(LollipopCutter{10, 0, 9}, {{0, 0}, {3, 9}, {0, 9}});
  EXPECT_EQ(length_mm(LollipopCutter{10, 6, 0}), 9);
  EXPECT_NEAR(depth(LollipopCutter{10, 6, 0}, 2, 5), 3, 1e-12);
  EXPECT_EQ(error_of(LollipopCutter{10, 0, 0}),
            "a lollipop needs a neck_diameter, or the length at which its ball ends [tool-dimensions-contradict]");
  EXPECT_EQ(error_of(LollipopCutter{10, 12, 0}),
            "neck_diameter 12 mm is not less than diameter 10 mm, that of the ball [tool-dimensions-contradict]");
  EXPECT_EQ(error_of(LollipopCutter{10, 0, 4}),
            "length 4 mm does not end within the upper half of the ball; it must lie between 5 mm and 10 mm "
            "[tool-dimensions-contradict]");
}

TEST(Shapes, SlotCuttersAreDiscs) {
  expect_points(TSlotCutter{20, 1, 2, 6}, {{0, 0}, {9, 0}, {10, 1}, {10, 4}, {8, 6}, {0, 6}});
  expect_points(TSlotCutter{20, 3, 3, 6}, {{0, 0}, {7, 0}, {10, 3}, {7, 6}, {0, 6}});
  expect_points(SlittingSawCutter{80, 2, 0, 0}, {{0, 0}, {40, 0}, {40, 2}, {0, 2}});
  expect_points(SlittingSawCutter{80, 2, 12, 3}, {{0, 0}, {6, 0}, {6, 3}, {40, 3}, {40, 5}, {0, 5}});
  EXPECT_EQ(length_mm(SlittingSawCutter{80, 2, 12, 3}), 5);
  EXPECT_EQ(error_of(TSlotCutter{20, 4, 3, 6}),
            "corner_radius 4 mm and upper_radius 3 mm do not fit into the length 6 mm; together they may be as large "
            "as that [tool-corner-radius-too-large]");
  EXPECT_EQ(
      error_of(TSlotCutter{20, 0, 11, 30}),
      "upper_radius 11 mm is larger than half the diameter; at most 10 mm is possible [tool-corner-radius-too-large]");
  EXPECT_EQ(error_of(SlittingSawCutter{80, 2, 12, 0}),
            "cap_diameter and cap_height belong together; give both, or neither [tool-dimensions-contradict]");
  EXPECT_EQ(
      error_of(SlittingSawCutter{80, 2, 80, 3}),
      "cap_diameter 80 mm is not less than diameter 80 mm; the cap would cover the blade [tool-dimensions-contradict]");
  EXPECT_EQ(error_of(SlittingSawCutter{80, 0, 0, 0}),
            "thickness is 0 mm; it must be greater than 0 [tool-dimension-not-positive]");
}

TEST(Shapes, DovetailIsWidestBelow) {
  const double top = 10 - 8 * std::tan(30 * std::numbers::pi / 180);
  expect_points(DovetailCutter{20, 0, 30, 8}, {{0, 0}, {10, 0}, {top, 8}, {0, 8}});
  EXPECT_EQ(error_of(DovetailCutter{20, 0, -30, 8}),
            "taper_angle is -30 degrees; it must lie between 0 and 90 [tool-angle-out-of-range]");
  EXPECT_EQ(error_of(DovetailCutter{10, 0, 45, 8}),
            "a side leaning inward by 45 degrees closes at z = 5 mm, below the top of the flutes at 8 mm; give a "
            "smaller angle or a smaller length [tool-taper-closes]");
}

TEST(Shapes, BarrelFlankIsAnArcThroughItsWidestPlace) {
  const double low = 6 - (48 - std::sqrt(48.0 * 48 - 12 * 12));
  expect_points(BarrelCutter{12, 48, 0, 0, 12, 24}, {{0, 0}, {low, 0}, {low, 24}, {0, 24}});
  const Profile rounded = profile_of(BarrelCutter{12, 48, 1, 0, 12, 24});
  ASSERT_EQ(rounded.elements.size(), 4u);
  EXPECT_TRUE(end_direction(rounded.elements[0]).isApprox(start_direction(rounded.elements[1]), 1e-12));
  EXPECT_TRUE(end_direction(rounded.elements[1]).isApprox(start_direction(rounded.elements[2]), 1e-12));
  EXPECT_EQ(compile_tool("", rounded).r_max_mm, 6) << "widest between the ends of the flank";
  const Profile taper = profile_of(BarrelCutter{12, 250, 1.5, 15, 14, 22});
  const Vec2 along = start_direction(taper.elements[2]);
  EXPECT_GT(along.x() / along.y(), std::tan(15 * std::numbers::pi / 180)) << "leans more below";
  EXPECT_EQ(error_of(BarrelCutter{12, 10, 0, 0, 12, 20}),
            "profile_radius 10 mm and axial_distance 12 mm: the flank meets the axis above the tip; give a larger "
            "profile_radius or a smaller axial_distance [tool-dimensions-contradict]");
  EXPECT_EQ(error_of(BarrelCutter{12, 20, 0, 0, 8, 40}),
            "profile_radius 20 mm: the flank meets the axis below the top of the flutes at 40 mm; give a larger "
            "profile_radius or a smaller length [tool-dimensions-contradict]");
  // (48^2 - 42^2 - 12^2) / (2 (48 - 12)) = 5.5
  EXPECT_EQ(error_of(BarrelCutter{12, 48, 6, 0, 12, 24}),
            "corner_radius 6 mm would begin beyond the axis; at most 5.5 mm is possible, which is a ball tip "
            "[tool-corner-radius-too-large]");
  EXPECT_EQ(profile_of(BarrelCutter{12, 48, 5.5, 0, 12, 24}).elements.size(), 3u) << "ball, flank, top";
}

TEST(Shapes, OvalAndLensTouchTheirCylinder) {
  // (90 - 1)^2 - (90 - 3)^2 = 352
  const double end = 1 + std::sqrt(352.0);
  const Profile oval = profile_of(OvalCutter{6, 1, 90, 30});
  ASSERT_EQ(oval.elements.size(), 4u);
  EXPECT_NEAR((oval.elements[1].b - Vec2(3, end)).norm(), 0, 1e-9);
  EXPECT_TRUE(end_direction(oval.elements[0]).isApprox(start_direction(oval.elements[1]), 1e-9));
  EXPECT_TRUE(end_direction(oval.elements[1]).isApprox(Vec2(0, 1), 1e-9));
  const Profile lens = profile_of(LensCutter{10, 100, 1, 20});
  ASSERT_EQ(lens.elements.size(), 4u);
  EXPECT_NEAR(lens.elements[1].b.y(), 100 - std::sqrt(99.0 * 99 - 16), 1e-9);
  EXPECT_TRUE(end_direction(lens.elements[0]).isApprox(start_direction(lens.elements[1]), 1e-9));
  EXPECT_NEAR(depth(LensCutter{10, 100, 1, 20}, 1, 2), 100 - std::sqrt(1 + 98.0 * 98), 1e-9);
  EXPECT_EQ(error_of(LensCutter{10, 4, 1, 20}),
            "profile_radius 4 mm is less than half the diameter; at least 5 mm is needed [tool-dimensions-contradict]");
  EXPECT_EQ(error_of(OvalCutter{6, 1, 90, 0.5}).substr(0, 33), "length 0.5 mm ends within the tip");
  EXPECT_EQ(error_of(OvalCutter{6, 0, 90, 20}),
            "corner_radius is 0 mm; it must be greater than 0 [tool-dimension-not-positive]");
}

TEST(Shapes, FaceMillMayLeanAndBeHollow) {
  expect_points(FaceMillCutter{50, 0, 45, 60, 0, 0, 20}, {{0, 0}, {25, 0}, {30, 5}, {30, 20}, {0, 20}});
  const FaceMillCutter ring{50, 2, 0, 0, 30, 6, 20};
  expect_points(ring, {{0, 6}, {15, 6}, {15, 0}, {23, 0}, {25, 2}, {25, 20}, {0, 20}});
  EXPECT_FALSE(is_single_valued(profile_of(ring)));
  EXPECT_LT(depth(ring, 5, 3), 0) << "the hollow is free";
  EXPECT_NEAR(depth(ring, 20, 3), 3, 1e-12);
  EXPECT_EQ(error_of(FaceMillCutter{50, 0, 45, 0, 0, 0, 20}),
            "an edge with a taper_angle needs a largest_diameter greater than diameter 50 mm, and the other way round; "
            "give both, or neither [tool-dimensions-contradict]");
  EXPECT_EQ(
      error_of(FaceMillCutter{50, 0, 45, 40, 0, 0, 20}),
      "largest_diameter 40 mm is less than diameter 50 mm; it must be at least that [tool-dimensions-contradict]");
  EXPECT_EQ(error_of(FaceMillCutter{50, 0, 0, 0, 30, 20, 20}),
            "recess_depth 20 mm goes through the cutter, whose length is 20 mm; it must be less "
            "[tool-dimensions-contradict]");
  EXPECT_EQ(error_of(FaceMillCutter{50, 0, 0, 0, 30, 0, 20}),
            "recess_diameter and recess_depth belong together; give both, or neither [tool-dimensions-contradict]");
  EXPECT_EQ(error_of(FaceMillCutter{50, 0, 0, 0, 50, 3, 20}),
            "recess_diameter 50 mm is not less than diameter 50 mm [tool-dimensions-contradict]");
  EXPECT_EQ(error_of(FaceMillCutter{50, 12, 0, 0, 30, 3, 20}),
            "corner_radius 12 mm has no room between the underside and the edge; at most 10 mm is possible "
            "[tool-corner-radius-too-large]");
  EXPECT_EQ(error_of(FaceMillCutter{50, 0, 45, 100, 0, 0, 20}),
            "length 20 mm ends within the leaning edge, which reaches up to z = 25 mm; give a greater length "
            "[tool-length-too-short]");
}

TEST(Shapes, RadiusMillIsConcave) {
  const RadiusCutter cutter{6, 1, 3, 16, 10};
  expect_points(cutter, {{0, 0}, {3, 0}, {3, 1}, {6, 4}, {8, 4}, {8, 10}, {0, 10}});
  const Profile profile = profile_of(cutter);
  EXPECT_TRUE(profile.elements[2].is_concave);
  EXPECT_NEAR((profile.elements[2].center - Vec2(6, 1)).norm(), 0, 1e-12);
  EXPECT_EQ(error_of(RadiusCutter{6, 0, 3, 10, 10}),
            "diameter 10 mm is less than tip_diameter and two profile_radius together, 12 mm; it must be at least that "
            "[tool-dimensions-contradict]");
  EXPECT_EQ(
      error_of(RadiusCutter{6, 1, 3, 16, 3}),
      "length 3 mm ends within the arc, which reaches up to z = 4 mm; give a greater length [tool-length-too-short]");
}

TEST(Shapes, FreeProfileIsBuiltFromPointsAndArcs) {
  using SegmentShape = ProfilePoint::SegmentShape;
  const ProfileCutter cutter{{{SegmentShape::straight, 0, 0, 0},
                              {SegmentShape::straight, 3, 0, 0},
                              {SegmentShape::convex, 5, 2, 2},
                              {SegmentShape::concave, 5, 8, 4},
                              {SegmentShape::straight, 5, 12, 0}}};
  const Profile profile = profile_of(cutter);
  ASSERT_EQ(profile.elements.size(), 5u);
  EXPECT_NEAR((profile.elements[1].center - Vec2(3, 2)).norm(), 0, 1e-12);
  EXPECT_NEAR((profile.elements[2].center - Vec2(5 + std::sqrt(7), 5)).norm(), 0, 1e-12);
  EXPECT_EQ(length_mm(cutter), 12);
  EXPECT_EQ(error_of(ProfileCutter{}), "the profile has 0 points; it needs at least 2 [tool-profile-broken]");
  EXPECT_EQ(error_of(ProfileCutter{{{SegmentShape::straight, 0, 0, 0}, {SegmentShape::convex, 8, 0, 3}}}),
            "point 2: radius 3 mm is too small to reach from the point before; at least 4 mm is needed "
            "[tool-profile-broken]");
  EXPECT_EQ(error_of(ProfileCutter{{{SegmentShape::straight, 0, 0, 0}, {SegmentShape::straight, -1, 5, 0}}}),
            "point 2: r is -1 mm; a radius is 0 or more [tool-profile-broken]");
  EXPECT_EQ(
      error_of(ProfileCutter{
          {{SegmentShape::straight, 0, 10, 0}, {SegmentShape::straight, 5, 10, 0}, {SegmentShape::straight, 5, 0, 0}}}),
      "these numbers make no closed profile: the contour does not end above its start (points in order from the tip "
      "up, the tool on their left) [tool-profile-broken]");
  EXPECT_EQ(error_of(ProfileCutter{{{SegmentShape::convex, 3, 0, 2}, {SegmentShape::straight, 5, 10, 0}}}),
            "point 1 has an arc, but nothing comes before it; arcs lead to a point from the one before "
            "[tool-profile-broken]");
}

TEST(Shapes, NominalSizeIsTheCatalogues) {
  EXPECT_EQ(nominal_size(BallCutter{10, 30}).corner_radius_mm, 5);
  EXPECT_EQ(nominal_size(DrillCutter{8, 118, 30}).diameter_mm, 8);
  EXPECT_EQ(nominal_size(AptCutter{16, 2, 0, 0, 0, 0, 30}).diameter_mm, 16);
  EXPECT_EQ(nominal_size(RadiusCutter{6, 0, 3, 0, 10}).diameter_mm, 12);
}

}  // namespace
}  // namespace gouge::cutter_shapes_test

#include "toolmodels/cutter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "tests/toolmodels/sample_tools.h"

namespace gouge::cutter_test {
namespace {

using Strings = std::vector<std::string>;

std::string error_of(const Cutter& cutter) {
  const Result<Profile> profile = make_cutter_profile(cutter);
  return profile ? "none" : profile.error().message + " [" + profile.error().code + "]";
}

void expect_same(const Cutter& one, const Cutter& other) {
  const Result<Profile> p = make_cutter_profile(one);
  const Result<Profile> q = make_cutter_profile(other);
  ASSERT_TRUE(p.has_value());
  ASSERT_TRUE(q.has_value());
  ASSERT_EQ(p->elements.size(), q->elements.size());
  for (std::size_t i = 0; i < p->elements.size(); ++i) {
    EXPECT_TRUE(p->elements[i].a.isApprox(q->elements[i].a, 1e-12)) << i;
    EXPECT_TRUE(p->elements[i].b.isApprox(q->elements[i].b, 1e-12)) << i;
    EXPECT_NEAR(p->elements[i].radius_mm, q->elements[i].radius_mm, 1e-12) << i;
  }
}

TEST(Cutter, EverySampleIsAClosedSingleValuedContour) {
  for (const ToolAssembly& tool : test::sample_tools()) {
    const Result<Profile> profile = make_cutter_profile(tool.cutter);
    ASSERT_TRUE(profile.has_value()) << tool.name;
    EXPECT_EQ(verify_profile(*profile), Strings{}) << tool.name;
    EXPECT_TRUE(is_single_valued(*profile)) << tool.name;
  }
}

TEST(Cutter, BallIsTheBullNoseWithHalfTheDiameter) {
  expect_same(BallCutter{10, 30}, BullNoseCutter{10, 5, 30});
  expect_same(FlatCutter{10, 30}, BullNoseCutter{10, 0, 30});
}

TEST(Cutter, BullNoseHasItsCornerWhereTheCatalogueDrawsIt) {
  const Result<Profile> profile = make_cutter_profile(BullNoseCutter{16, 2, 25});
  ASSERT_EQ(profile->elements.size(), 4u);
  EXPECT_EQ(profile->elements[1].a, Vec2(6, 0));
  EXPECT_EQ(profile->elements[1].b, Vec2(8, 2));
  EXPECT_EQ(profile->elements[1].center, Vec2(6, 2));
}

TEST(Cutter, TaperedSideLeansOutwardFromItsTangentPoint) {
  const Result<Profile> profile = make_cutter_profile(TaperedCutter{4, 2, 5, 30});
  ASSERT_EQ(profile->elements.size(), 3u) << "arc, side, top";
  const double t = 5 * std::numbers::pi / 180;
  EXPECT_EQ(profile->elements[0].center, Vec2(0, 2));
  EXPECT_TRUE(profile->elements[0].b.isApprox(Vec2(2 * std::cos(t), 2 - 2 * std::sin(t)), 1e-14));
  const Vec2 along = start_direction(profile->elements[1]);
  EXPECT_NEAR(along.x() / along.y(), std::tan(t), 1e-14);
  EXPECT_EQ(profile->elements[1].b.y(), 30);
}

TEST(Cutter, TaperWithoutAngleIsTheStraightTool) {
  expect_same(TaperedCutter{10, 1, 0, 30}, BullNoseCutter{10, 1, 30});
}

TEST(Cutter, SevenNumbersOfRealFilesMakeTheToolsTheyMean) {
  expect_same(AptCutter{14, 0, 7, 0, 0, 0, 84}, FlatCutter{14, 84});
  expect_same(AptCutter{14, 7, 0, 7, 0, 0, 73}, BallCutter{14, 73});
  expect_same(AptCutter{10, 5, 0, 0, 0, 0, 73}, BallCutter{10, 73});  // writers that leave e and f at 0
  expect_same(AptCutter{16, 2, 99, 99, 0, 0, 25}, BullNoseCutter{16, 2, 25});
  const Result<Profile> drill = make_cutter_profile(AptCutter{10, 0, 6, 3.004303, 31, 0, 130});
  ASSERT_TRUE(drill.has_value());
  EXPECT_EQ(drill->elements[0].a, Vec2(0, 0));
  EXPECT_NEAR(drill->elements[0].b.y(), 5 * std::tan(31 * std::numbers::pi / 180), 1e-14);
  EXPECT_EQ(drill->elements[0].b.x(), 5);
}

TEST(Cutter, AptCornerTouchesBottomLineAndSide) {
  const Result<Profile> profile = make_cutter_profile(AptCutter{20, 2, 0, 0, 20, 15, 30});
  ASSERT_EQ(profile->elements.size(), 4u);
  const ProfileElement& bottom = profile->elements[0];
  const ProfileElement& arc = profile->elements[1];
  EXPECT_EQ(arc.radius_mm, 2);
  EXPECT_TRUE(start_direction(arc).isApprox(end_direction(bottom), 1e-12));
  EXPECT_TRUE(end_direction(arc).isApprox(start_direction(profile->elements[2]), 1e-12));
  // Bottom line and side, continued, meet at the diameter d.
  const Vec2 u = start_direction(bottom), v = start_direction(profile->elements[2]);
  const double t = ((arc.b - bottom.a).x() * v.y() - (arc.b - bottom.a).y() * v.x()) / (u.x() * v.y() - u.y() * v.x());
  EXPECT_NEAR((bottom.a + t * u).x(), 10, 1e-12);
}

TEST(Cutter, AptContradictionIsReported) {
  EXPECT_EQ(apt_contradiction({16, 0, 8, 0, 0, 0, 93}), "");
  EXPECT_EQ(apt_contradiction({16, 2, 0, 0, 0, 0, 93}), "");
  EXPECT_EQ(apt_contradiction({12, 2, 8, 2, 0, 0, 93}), "") << "e as the diameter of the flat tip";
  EXPECT_EQ(apt_contradiction({12, 2, 7, 2, 0, 0, 93}),
            "e = 7 mm, f = 2 mm do not place the corner where d, r, alpha and beta do (e = 4 mm, f = 2 mm); built from "
            "d, r, alpha and beta");
}

TEST(Cutter, WrongDimensionsNameTheFieldAndWhatIsAllowed) {
  EXPECT_EQ(
      error_of(BullNoseCutter{10, 6, 30}),
      "corner_radius 6 mm is larger than half the diameter; at most 5 mm is possible [tool-corner-radius-too-large]");
  EXPECT_EQ(error_of(BullNoseCutter{10, -1, 30}),
            "corner_radius is -1 mm; give 0 for a sharp corner, or a positive radius [tool-corner-radius-negative]");
  EXPECT_EQ(error_of(FlatCutter{0, 30}), "diameter is 0 mm; it must be greater than 0 [tool-dimension-not-positive]");
  EXPECT_EQ(error_of(FlatCutter{10, -3}), "length is -3 mm; it must be greater than 0 [tool-dimension-not-positive]");
  EXPECT_EQ(error_of(FlatCutter{10, std::nan("")}),
            "length is not a number; it must be greater than 0 [tool-dimension-not-positive]");
  EXPECT_EQ(error_of(FlatCutter{10, 1e300}),
            "length is larger than 100000 mm; check the unit of the file [tool-dimension-too-large]");
  EXPECT_EQ(
      error_of(BallCutter{10, 4}),
      "length 4 mm ends within the tip, which reaches up to z = 5 mm; give a greater length [tool-length-too-short]");
  EXPECT_EQ(error_of(TaperedCutter{10, 0, -45, 30}),
            "a side leaning inward by 45 degrees closes at z = 5 mm, below the top of the flutes at 30 mm; give a "
            "smaller angle or a smaller length [tool-taper-closes]");
  EXPECT_EQ(error_of(TaperedCutter{10, 0, 90, 30}),
            "taper_angle is 90 degrees; it must lie between -90 and 90 [tool-angle-out-of-range]");
  EXPECT_EQ(error_of(AptCutter{10, 0, 0, 0, 60, 40, 30}),
            "beta is 40 degrees; it must lie between -90 and 30 for alpha 60 [tool-angle-out-of-range]");
  EXPECT_EQ(error_of(AptCutter{10, -1, 0, 0, 0, 0, 30}),
            "r is -1 mm; it must not be negative [tool-corner-radius-negative]");
  EXPECT_EQ(error_of(AptCutter{10, 0, 0, 0, 0, 0, 0}),
            "h is 0 mm; it must be greater than 0 [tool-dimension-not-positive]");
}

TEST(Cutter, NoNumbersWhateverMakeABrokenContour) {
  test::Scatter random(11);
  const auto draw = [&] {
    const double odd[] = {0, -1, 1e-12, 1e6, 90, -90, 45, std::numeric_limits<double>::infinity(), std::nan("")};
    return random.next() % 6 == 0 ? odd[random.next() % 9] : random.in(-5, 60);
  };
  int good = 0;
  for (int k = 0; k < 200000; ++k) {
    const Cutter cutter = k % 2 == 0 ? Cutter(AptCutter{draw(), draw(), draw(), draw(), draw(), draw(), draw()})
                                     : Cutter(TaperedCutter{draw(), draw(), draw(), draw()});
    const Result<Profile> profile = make_cutter_profile(cutter);
    if (!profile) continue;
    ++good;
    ASSERT_EQ(verify_profile(*profile), Strings{}) << k;
    const auto* apt = std::get_if<AptCutter>(&cutter);
    if (apt == nullptr || apt->alpha_deg >= 0) {
      ASSERT_TRUE(is_single_valued(*profile)) << k;
    }
  }
  EXPECT_GT(good, 1000);
}

}  // namespace
}  // namespace gouge::cutter_test

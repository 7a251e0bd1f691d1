#include "toolmodels/profile.h"

#include <gtest/gtest.h>

#include <numbers>

namespace gouge {
namespace {

using Strings = std::vector<std::string>;

Profile ball_and_side() {
  Profile p;
  p.elements = {make_convex_arc(Body::cutter, {0, 0}, {5, 5}, {0, 5}, 5),
                make_segment(Body::cutter, {5, 5}, {5, 20}), make_segment(Body::cutter, {5, 20}, {0, 20})};
  return p;
}

TEST(Profile, DirectionsFollowTheContour) {
  const Profile p = ball_and_side();
  EXPECT_TRUE(start_direction(p.elements[0]).isApprox(Vec2(1, 0)));
  EXPECT_TRUE(end_direction(p.elements[0]).isApprox(Vec2(0, 1)));
  EXPECT_TRUE(outward_normal(start_direction(p.elements[1])).isApprox(Vec2(1, 0)));
  EXPECT_NEAR(sweep_rad(p.elements[0]), std::numbers::pi / 2, 1e-15);
  const ProfileElement fillet = make_concave_arc(Body::shank, {4, 7}, {7, 10}, {7, 7}, 3);
  EXPECT_TRUE(start_direction(fillet).isApprox(Vec2(0, 1)));
  EXPECT_TRUE(end_direction(fillet).isApprox(Vec2(1, 0)));
  EXPECT_NEAR(sweep_rad(fillet), std::numbers::pi / 2, 1e-15);
}

TEST(Profile, SamplesLieOnTheArcAndKeepItsEnds) {
  const std::vector<Vec2> points = sample(ball_and_side().elements[0], 8);
  ASSERT_EQ(points.size(), 9u);
  EXPECT_EQ(points.front(), Vec2(0, 0));
  EXPECT_EQ(points.back(), Vec2(5, 5));
  for (const Vec2& p : points) EXPECT_NEAR((p - Vec2(0, 5)).norm(), 5, 1e-14);
}

TEST(Profile, SoundContourHasNoComplaints) {
  EXPECT_EQ(verify_profile(ball_and_side()), Strings{});
  EXPECT_TRUE(is_single_valued(ball_and_side()));
  EXPECT_EQ(size_of(ball_and_side()), 20);
}

TEST(Profile, EveryBrokenInvariantIsNamed) {
  EXPECT_EQ(verify_profile({}), Strings{"the contour is empty"});
  Profile p = ball_and_side();
  p.elements[1].a = Vec2(5, 6);
  EXPECT_EQ(verify_profile(p), Strings{"element 0 does not end where the next one starts"});
  p = ball_and_side();
  p.elements[0].radius_mm = 4;
  EXPECT_EQ(verify_profile(p), Strings{"element 0 does not lie on its circle"});
  p = ball_and_side();
  p.elements.pop_back();
  EXPECT_EQ(verify_profile(p), Strings{"the contour does not end on the axis"});
  p = ball_and_side();
  p.elements.insert(p.elements.begin() + 2, make_segment(Body::cutter, {5, 20}, {5, 20}));
  EXPECT_EQ(verify_profile(p), Strings{"element 2 has no length"});
  Profile crossing;
  const Vec2 points[] = {{0, 0}, {10, 0}, {1, 10}, {10, 10}, {1, -5}, {0, 20}};
  for (int i = 0; i < 5; ++i)
    crossing.elements.push_back(make_segment(Body::cutter, points[i], points[i + 1]));
  EXPECT_FALSE(verify_profile(crossing).empty());
  Profile clockwise;
  const Vec2 back[] = {{0, 20}, {5, 20}, {5, 0}, {0, 0}};
  for (int i = 0; i < 3; ++i) clockwise.elements.push_back(make_segment(Body::cutter, back[i], back[i + 1]));
  EXPECT_EQ(verify_profile(clockwise), Strings{"the solid is not on the left of the contour"});
}

TEST(Profile, AnUndercutSeenAlongTheAxisIsNotSingleValued) {
  Profile cup;
  const Vec2 points[] = {{0, 3}, {4, 0}, {5, 0}, {5, 20}, {0, 20}};
  for (int i = 0; i < 4; ++i) cup.elements.push_back(make_segment(Body::cutter, points[i], points[i + 1]));
  EXPECT_EQ(verify_profile(cup), Strings{});
  EXPECT_FALSE(is_single_valued(cup));
}

}  // namespace
}  // namespace gouge

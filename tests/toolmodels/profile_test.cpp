#include "toolmodels/profile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace gouge::profile_test {
namespace {

using Strings = std::vector<std::string>;

Profile ball_and_side() {
  Profile p;
  p.elements = {make_convex_arc(Body::cutter, {0, 0}, {5, 5}, {0, 5}, 5), make_segment(Body::cutter, {5, 5}, {5, 20}),
                make_segment(Body::cutter, {5, 20}, {0, 20})};
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
  // Over the axis between two of the points a picture would be drawn with.
  Profile dip;
  dip.elements = {make_concave_arc(Body::cutter, {0, 0}, {5, 5}, {4.999, 0.001}, 4.999000100020002),
                  make_segment(Body::cutter, {5, 5}, {0, 5})};
  dip.elements[0].b = Vec2(5, 0.001 + std::sqrt(4.999000100020002 * 4.999000100020002 - 1e-6));
  dip.elements[1].a = dip.elements[0].b;
  EXPECT_EQ(verify_profile(dip), Strings{"element 0 crosses the axis"});
  Profile crossing;
  const Vec2 points[] = {{0, 0}, {10, 0}, {1, 10}, {10, 10}, {1, -5}, {0, 20}};
  for (int i = 0; i < 5; ++i) crossing.elements.push_back(make_segment(Body::cutter, points[i], points[i + 1]));
  EXPECT_FALSE(verify_profile(crossing).empty());
  Profile pinched;
  const Vec2 twice[] = {{0, 0}, {8, 0}, {5, 5}, {8, 3}, {8, 9}, {5, 5}, {3, 9}, {0, 9}};
  for (int i = 0; i < 7; ++i) pinched.elements.push_back(make_segment(Body::cutter, twice[i], twice[i + 1]));
  EXPECT_EQ(verify_profile(pinched).front(), "element 4 touches the end of element 1");
  Profile clockwise;
  const Vec2 back[] = {{0, 20}, {5, 20}, {5, 0}, {0, 0}};
  for (int i = 0; i < 3; ++i) clockwise.elements.push_back(make_segment(Body::cutter, back[i], back[i + 1]));
  EXPECT_EQ(verify_profile(clockwise), Strings{"the contour does not end above its start"});
  Profile flat_ring;
  const Vec2 ring[] = {{0, 3}, {4, 0}, {9, 0}, {9, 3}, {0, 3}};
  for (int i = 0; i < 4; ++i) flat_ring.elements.push_back(make_segment(Body::cutter, ring[i], ring[i + 1]));
  EXPECT_EQ(verify_profile(flat_ring), Strings{"the contour does not end above its start"});
}

TEST(Profile, AnUndercutSeenAlongTheAxisIsNotSingleValued) {
  Profile cup;
  const Vec2 points[] = {{0, 3}, {4, 0}, {5, 0}, {5, 20}, {0, 20}};
  for (int i = 0; i < 4; ++i) cup.elements.push_back(make_segment(Body::cutter, points[i], points[i + 1]));
  EXPECT_EQ(verify_profile(cup), Strings{});
  EXPECT_FALSE(is_single_valued(cup));
}

TEST(Profile, AnArcThatRunsDownOnTheLeftIsNotSingleValued) {
  // A rim of half a circle under a hollow bottom, and the same half circle as a nose that is allowed.
  Profile ring;
  ring.elements = {make_segment(Body::cutter, {0, 3}, {4, 3}), make_convex_arc(Body::cutter, {4, 3}, {8, 3}, {6, 3}, 2),
                   make_segment(Body::cutter, {8, 3}, {8, 20}), make_segment(Body::cutter, {8, 20}, {0, 20})};
  EXPECT_EQ(verify_profile(ring), Strings{});
  EXPECT_FALSE(is_single_valued(ring));
  Profile disc;
  disc.elements = {make_segment(Body::cutter, {0, 0}, {5, 0}), make_convex_arc(Body::cutter, {5, 0}, {5, 4}, {5, 2}, 2),
                   make_segment(Body::cutter, {5, 4}, {0, 4})};
  EXPECT_TRUE(is_single_valued(disc));
}

}  // namespace
}  // namespace gouge::profile_test

#include "lib/tilt/feed_directions.h"

#include <gtest/gtest.h>

#include "tests/lib/tilt/tilt_bench.h"

namespace gouge::feed_directions_test {
namespace {

using namespace tilt_bench;

/// Positions with the axis Z through these tips, all reached clean.
std::vector<TiltPosition> through(const std::vector<Vec3>& tips) {
  std::vector<TiltPosition> positions;
  for (const Vec3& tip : tips) {
    TiltPosition at;
    at.programmed = {tip, Vec3::UnitZ()};
    at.first = Vec3(0.6, 0.8, 0);
    at.is_reached_clean = true;
    if (!positions.empty()) {
      const TiltPosition& last = positions.back();
      at.arc_length_mm = last.arc_length_mm + (tip - last.programmed.tip).norm();
    }
    positions.push_back(at);
  }
  return positions;
}

void expect_first(const std::vector<TiltPosition>& positions, std::size_t i, const Vec3& direction) {
  EXPECT_NEAR((positions[i].first - direction).norm(), 0, 1e-12) << i;
}

TEST(FeedDirections, APlungeAndARetractTakeThatOfTheirPass) {
  std::vector<TiltPosition> positions =
      through({{0, 0, 20}, {0, 0, 10}, {0, 0, 0}, {0, 5, 0}, {0, 10, 0}, {0, 10, 10}, {0, 10, 20}});
  follow_feed(positions);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    EXPECT_FALSE(positions[i].is_fixed()) << i;
    expect_first(positions, i, Vec3::UnitY());
  }
}

TEST(FeedDirections, BetweenTwoPassesChangeWhereTheToolIsFarthestFromCollisions) {
  // Along Y, up, and along X. The motions to z = 10 and to the last position collide.
  std::vector<TiltPosition> positions =
      through({{0, 0, 0}, {0, 5, 0}, {0, 5, 10}, {0, 5, 20}, {0, 5, 30}, {5, 5, 30}, {10, 5, 30}});
  positions[2].is_reached_clean = positions[6].is_reached_clean = false;
  follow_feed(positions);
  for (std::size_t i = 0; i < positions.size(); ++i) EXPECT_EQ(positions[i].is_fixed(), i == 3) << i;
  EXPECT_TRUE(positions[3].stays_programmed());
  for (const std::size_t i : {0U, 1U, 2U}) expect_first(positions, i, Vec3::UnitY());
  for (const std::size_t i : {4U, 5U, 6U}) expect_first(positions, i, Vec3::UnitX());
}

TEST(FeedDirections, AreFixedAtACornerAndNotAtARampInTheFeedDirection) {
  std::vector<TiltPosition> positions = through({{0, -5, 4}, {0, 0, 0}, {0, 5, 0}, {5, 5, 0}});
  follow_feed(positions);
  for (std::size_t i = 0; i < positions.size(); ++i) EXPECT_EQ(positions[i].is_fixed(), i == 2) << i;
  expect_first(positions, 1, Vec3::UnitY());
}

TEST(FeedDirections, StayAsTheyAreOnMotionsAlongTheAxisAlone) {
  std::vector<TiltPosition> positions = through({{0, 0, 20}, {0, 0, 10}, {0, 0, 0}});
  follow_feed(positions);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    EXPECT_FALSE(positions[i].is_fixed()) << i;
    expect_first(positions, i, Vec3(0.6, 0.8, 0));
  }
}

TEST(FeedDirections, LetASideTiltFreeAPlungeWithItsPass) {
  const Bench bench(row(-40, 40, 5), {floor_plate(), shapes::box(Vec3(9, -100, -5), Vec3(60, 100, 90))});
  TiltOptions side;
  side.freedom = TiltFreedom::side;
  const TiltPlan plan = bench.plan(side);
  expect_clean(bench, plan);
  EXPECT_GT(largest_tilt(plan), min_tilt(9));
  for (const TiltedPosition& p : positions_of(plan)) EXPECT_NEAR(p.pose.axis.y(), 0, 1e-9);
}

}  // namespace
}  // namespace gouge::feed_directions_test

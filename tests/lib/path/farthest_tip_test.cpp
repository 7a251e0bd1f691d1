#include "lib/path/farthest_tip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "tests/support/paths.h"
#include "tests/support/scatter.h"

namespace gouge::farthest_tip_test {
namespace {

constexpr double kWithin_mm = 1e-3;

double distance_from_all(const Vec3& tip, const FeedsInBlocks& feeds) {
  double least_mm = std::numeric_limits<double>::infinity();
  for (const MotionChord& feed : feeds.all())
    least_mm = std::min(least_mm, distance_from({tip, Vec3::UnitZ()}, feed).tip_mm);
  return least_mm;
}

/// The largest distance of many places along a motion.
double sampled_mm(const Vec3& from, const Vec3& to, const FeedsInBlocks& feeds) {
  constexpr int kPlaces = 300;
  double largest_mm = 0;
  for (int k = 0; k <= kPlaces; ++k)
    largest_mm = std::max(largest_mm, distance_from_all(from + (to - from) * k / kPlaces, feeds));
  return largest_mm;
}

TEST(FarthestTip, IsAsFarAsTheFarthestOfManyPlaces) {
  test::Scatter scatter(7);
  const auto place = [&] { return scatter.point(10); };
  for (int round = 0; round < 60; ++round) {
    std::vector<Pose> poses;
    for (int k = 0; k < 3 + round % 20; ++k) poses.push_back({place(), Vec3::UnitZ()});
    const FeedsInBlocks feeds(chords_of_feeds(paths::through(poses)));
    const Vec3 from = round % 3 == 0 ? poses[1].tip : place(), to = round % 5 == 0 ? poses.back().tip : place();
    FarthestTip farthest(feeds, kWithin_mm);
    const bool is_farther = farthest.add(from, to);
    EXPECT_EQ(is_farther, farthest.distance_mm() > 0);
    const double sampled = sampled_mm(from, to, feeds);
    EXPECT_LE(sampled, 1.01 * farthest.distance_mm() + 1e-9) << "round " << round;
    EXPECT_LE(farthest.distance_mm(), sampled + 0.5 * (to - from).norm() / 300 + 1e-9) << "round " << round;
  }
}

TEST(FarthestTip, MeetsManyFeedsAlongOneMotion) {
  std::vector<Pose> poses;
  for (int k = 0; k <= 1000; ++k) poses.push_back(paths::upright(0.1 * k, k == 637 ? 0.02 : 0, 0));
  const FeedsInBlocks feeds(chords_of_feeds(paths::through(poses)));
  FarthestTip farthest(feeds, kWithin_mm);
  farthest.add({0, 0, 0}, {100, 0, 0});
  const double depth_mm = 0.02 / std::hypot(1, 0.2);
  EXPECT_GE(1.01 * farthest.distance_mm(), depth_mm);
  EXPECT_LE(farthest.distance_mm(), depth_mm + 1e-12);
}

TEST(FarthestTip, NamesTheFeedNearestToIt) {
  Toolpath path = paths::through({paths::upright(0, 0, 0), paths::upright(10, 0, 0), paths::upright(10, 0, 40)});
  path.moves.push_back(path.moves[0]);
  path.moves.back().has_start = false;
  path.moves.back().end = paths::upright(40, 0, 0);
  const FeedsInBlocks feeds(chords_of_feeds(path));
  FarthestTip farthest(feeds, kWithin_mm);
  EXPECT_FALSE(farthest.add({0, 0, 0}, {10, 0, 0}));
  EXPECT_TRUE(farthest.add({10, 0, 0}, {40, 0, 0}));
  EXPECT_NEAR(farthest.distance_mm(), 15, 0.2);
  EXPECT_TRUE(farthest.nearest_move() == 2 || farthest.nearest_move() == 3);
  EXPECT_FALSE(farthest.add({10, 0, 0}, {30, 0, 0})) << "a part of the same way is no farther";
}

}  // namespace
}  // namespace gouge::farthest_tip_test

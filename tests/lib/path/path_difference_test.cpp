#include "lib/path/path_difference.h"

#include <gtest/gtest.h>

#include "tests/support/paths.h"

namespace gouge::path_difference_test {
namespace {

constexpr double kHeight_mm = 100;

/// A hole: down to R and out of it by rapids of this kind, and a feed between.
Toolpath hole(MoveKind of_rapids, MoveKind of_feed) {
  Toolpath path = paths::through({{{0, 0, 30}, Vec3::UnitZ()},
                                  {{0, 0, 2}, Vec3::UnitZ()},
                                  {{0, 0, -5}, Vec3::UnitZ()},
                                  {{0, 0, 30}, Vec3::UnitZ()}});
  for (const std::size_t rapid : {1U, 3U}) {
    path.moves[rapid].kind = of_rapids;
    path.moves[rapid].set_feed({0, FeedUnit::rapid});
  }
  path.moves[2].kind = of_feed;
  path.moves[0].kind = MoveKind::rapid;
  return path;
}

TEST(PathDifference, ComparesTheFeedsOfCyclesAlone) {
  const Toolpath cycle = hole(MoveKind::cycle, MoveKind::cycle), program = hole(MoveKind::rapid, MoveKind::feed);
  for (const auto& [one, other] : {std::pair{&cycle, &program}, std::pair{&program, &cycle}}) {
    const auto difference = measure_difference(*one, *other, kHeight_mm);
    ASSERT_TRUE(difference.has_value());
    EXPECT_EQ(difference->positions, 1U);
    EXPECT_LT(difference->tip_mm, 1e-12);
  }
}

TEST(PathDifference, NamesTheFarthestFeedAndTheNearestOneOfTheOther) {
  const Toolpath path = hole(MoveKind::rapid, MoveKind::feed);
  Toolpath other = path;
  other.moves[2].end.tip.z() = -4;
  const auto difference = measure_difference(path, other, kHeight_mm);
  ASSERT_TRUE(difference.has_value());
  EXPECT_NEAR(difference->tip_mm, 1, 1e-12);
  EXPECT_EQ(difference->tip_move, 2U);
  EXPECT_EQ(difference->tip_other, 2U);
}

TEST(PathDifference, CountsFeedRatesThatDifferByMoreThanTheirRounding) {
  Toolpath path = hole(MoveKind::rapid, MoveKind::feed);
  path.moves[2].set_feed({800, FeedUnit::per_minute});
  Toolpath other = path;
  const auto count = [&](double feed, FeedUnit unit) {
    other.moves[2].set_feed({feed, unit});
    return measure_difference(path, other, kHeight_mm)->other_feeds;
  };
  EXPECT_EQ(count(800.4, FeedUnit::per_minute), 0U);
  EXPECT_EQ(count(0, FeedUnit::not_stated), 0U);
  EXPECT_EQ(count(0.2, FeedUnit::per_revolution), 0U) << "the speed of the spindle is not known";
  EXPECT_EQ(count(808, FeedUnit::per_minute), 1U);
  const auto difference = measure_difference(path, other, kHeight_mm);
  EXPECT_EQ(difference->feed_move, 2U);
  EXPECT_EQ(difference->feed_other, 2U);
}

TEST(PathDifference, FindsNoOtherFeedInItsOwnCopy) {
  Toolpath path = paths::through({{{0, 0, 0}, Vec3::UnitZ()},
                                  {{10, 0, 0}, Vec3::UnitZ()},
                                  {{20, 0, 0}, Vec3::UnitZ()},
                                  {{10, 0, 0}, Vec3::UnitZ()},
                                  {{0, 0, 0}, Vec3::UnitZ()}});
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    path.moves[i].kind = MoveKind::feed;
    path.moves[i].set_feed({100.0 * static_cast<double>(i + 1), FeedUnit::per_minute});
  }
  EXPECT_EQ(measure_difference(path, path, kHeight_mm)->other_feeds, 0U);
}

}  // namespace
}  // namespace gouge::path_difference_test

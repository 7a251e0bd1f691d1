#include "lib/path/path_difference.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lib/path/motion_chords.h"
#include "tests/support/paths.h"

namespace gouge::path_difference_test {
namespace {

constexpr double kHeight_mm = 100, kWithin_mm = 1e-3;

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
    const auto difference = measure_difference(*one, *other, kHeight_mm, kWithin_mm);
    ASSERT_TRUE(difference.has_value());
    EXPECT_EQ(difference->positions, 1U);
    EXPECT_LT(difference->tip_mm, 1e-12);
  }
}

TEST(PathDifference, NamesTheFarthestFeedAndTheNearestOneOfTheOther) {
  const Toolpath path = hole(MoveKind::rapid, MoveKind::feed);
  Toolpath other = path;
  other.moves[2].end.tip.z() = -4;
  const auto difference = measure_difference(path, other, kHeight_mm, kWithin_mm);
  ASSERT_TRUE(difference.has_value());
  EXPECT_NEAR(difference->tip_mm, 1, 1e-12);
  EXPECT_EQ(difference->tip_move, 2U);
  EXPECT_EQ(difference->tip_other, 2U);
}

// Elsewhere on the path a smaller angle would make up for the distance, but the nearest tip is that of the same position.
TEST(PathDifference, OneWrongAxisIsAnAngleAndNoDistance) {
  const double s = std::sin(std::numbers::pi / 6), c = std::cos(std::numbers::pi / 6);
  Toolpath path = paths::through({{{0, 0, 0}, Vec3(-s, 0, c)},
                                  {{50, 0, 0}, Vec3::UnitZ()},
                                  {{100, 0, 0}, Vec3(s, 0, c)},
                                  {{150, 0, 0}, Vec3::UnitZ()}});
  for (Move& move : path.moves) move.kind = MoveKind::feed;
  Toolpath other = path;
  other.moves[2].end.axis = Vec3(-s, 0, c);
  for (const auto& [one, two] : {std::pair{&path, &other}, std::pair{&other, &path}}) {
    const auto difference = measure_difference(*one, *two, kHeight_mm, kWithin_mm);
    ASSERT_TRUE(difference.has_value());
    EXPECT_LT(difference->tip_mm, 1e-9);
    EXPECT_NEAR(difference->axis_rad, std::numbers::pi / 3, 1e-9);
    EXPECT_EQ(difference->axis_move, 2U);
  }
}

TEST(PathDifference, CountsFeedRatesThatDifferByMoreThanTheirRounding) {
  Toolpath path = hole(MoveKind::rapid, MoveKind::feed);
  path.moves[2].set_feed({800, FeedUnit::per_minute});
  Toolpath other = path;
  const auto count = [&](double feed, FeedUnit unit) {
    other.moves[2].set_feed({feed, unit});
    return measure_difference(path, other, kHeight_mm, kWithin_mm)->other_feeds;
  };
  EXPECT_EQ(count(800.4, FeedUnit::per_minute), 0U);
  EXPECT_EQ(count(0, FeedUnit::not_stated), 0U);
  EXPECT_EQ(count(0.2, FeedUnit::per_revolution), 0U) << "the speed of the spindle is not known";
  EXPECT_EQ(count(808, FeedUnit::per_minute), 1U);
  const auto difference = measure_difference(path, other, kHeight_mm, kWithin_mm);
  EXPECT_EQ(difference->feed_move, 2U);
  EXPECT_EQ(difference->feed_other, 2U);
  other.moves[2].set_feed({0, FeedUnit::not_stated});
  EXPECT_EQ(measure_difference(path, other, kHeight_mm, kWithin_mm)->unknown_feeds, 1U);
  EXPECT_EQ(measure_difference(other, path, kHeight_mm, kWithin_mm)->unknown_feeds, 1U);
  EXPECT_EQ(measure_difference(path, path, kHeight_mm, kWithin_mm)->unknown_feeds, 0U);
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
  EXPECT_EQ(measure_difference(path, path, kHeight_mm, kWithin_mm)->other_feeds, 0U);
}

/// A cut at z 0, with a plunge before and a retract after it.
Toolpath cut() {
  Toolpath path = paths::through({paths::upright(0, 0, 40), paths::upright(0, 0, 0), paths::upright(30, 0, 0),
                                  paths::upright(30, 0, 40), paths::upright(60, 5, 40)});
  for (const std::size_t rapid : {0U, 4U}) path.moves[rapid].kind = MoveKind::rapid;
  return path;
}

Toolpath with_rapid(Toolpath path, std::size_t move) {
  path.moves[move].kind = MoveKind::rapid;
  return path;
}

TEST(PathDifference, NamesAFeedWhoseEndOnlyARapidReaches) {
  const Toolpath path = cut(), other = with_rapid(path, 3);
  const auto difference = measure_difference(path, other, kHeight_mm, kWithin_mm);
  EXPECT_EQ(difference->rapids, 1U);
  EXPECT_EQ(difference->retracts, 1U);
  EXPECT_EQ(difference->rapid_move, 3U);
  EXPECT_EQ(difference->rapid_other, 3U);
  EXPECT_EQ(difference->tip_mm, 0) << "it lies on the rapid";
  EXPECT_EQ(measure_difference(other, path, kHeight_mm, kWithin_mm)->rapids, 0U);
  EXPECT_EQ(measure_difference(path, path, kHeight_mm, kWithin_mm)->rapids, 0U);
}

// The next feed begins at the end of the rapid, so the end alone shows no difference.
TEST(PathDifference, NamesACutThatIsARapidBetweenFeeds) {
  const Toolpath path = cut(), other = with_rapid(path, 2);
  const auto difference = measure_difference(path, other, kHeight_mm, kWithin_mm);
  EXPECT_EQ(difference->rapids, 1U);
  EXPECT_EQ(difference->retracts, 0U);
  EXPECT_EQ(difference->rapid_move, 2U);
}

// Both ends of the feed lie on feeds of the other path.
TEST(PathDifference, FindsAFeedThroughPlacesThatTheOtherPathPassesAbove) {
  Toolpath path = paths::through({paths::upright(0, 0, 40), paths::upright(0, 0, 0), paths::upright(10, 0, 0),
                                  paths::upright(10, 0, 40), paths::upright(50, 0, 40), paths::upright(50, 0, 0)});
  for (const std::size_t rapid : {0U, 3U, 4U}) path.moves[rapid].kind = MoveKind::rapid;
  Toolpath other = path;
  other.moves.erase(other.moves.begin() + 3, other.moves.begin() + 5);
  const auto difference = measure_difference(other, path, kHeight_mm, kWithin_mm);
  EXPECT_NEAR(difference->tip_mm, 20, 0.2);
  EXPECT_EQ(difference->tip_move, 3U);
  EXPECT_TRUE(difference->is_tip_inside);
  EXPECT_FALSE(measure_difference(path, path, kHeight_mm, kWithin_mm)->is_tip_inside);
}

TEST(PathDifference, NamesACutBeforeRetractsThatAreRapids) {
  Toolpath path = cut();
  path.moves.push_back(path.moves[2]);
  path.moves.back().end = paths::upright(60, 5, 0);
  path.moves.push_back(path.moves.back());
  path.moves.back().end = paths::upright(90, 5, 0);
  path.moves.push_back(path.moves.back());
  path.moves.back().end = paths::upright(90, 5, 40);
  const Toolpath other = with_rapid(with_rapid(with_rapid(path, 3), 6), 7);
  const auto difference = measure_difference(path, other, kHeight_mm, kWithin_mm);
  EXPECT_EQ(difference->rapids, 3U);
  EXPECT_EQ(difference->retracts, 2U);
  EXPECT_EQ(difference->rapid_move, 6U);
}

TEST(PathDifference, NamesEachFeedOnOneRapid) {
  const Toolpath one_rapid = with_rapid(cut(), 3);
  Toolpath two_feeds = cut();
  Move half = two_feeds.moves[3];
  half.end = paths::upright(30, 0, 15);
  two_feeds.moves.insert(two_feeds.moves.begin() + 3, half);
  EXPECT_EQ(measure_difference(two_feeds, one_rapid, kHeight_mm, kWithin_mm)->rapids, 2U);
}

// The last position is 1 mm too high; then it lies on the retract of the other path by chance.
TEST(PathDifference, AWrongPositionOnARetractIsADistance) {
  const Toolpath path = with_rapid(cut(), 3);
  Toolpath other = path;
  other.moves[2].end.tip.z() = 1;
  const auto difference = measure_difference(other, path, kHeight_mm, kWithin_mm);
  EXPECT_EQ(difference->rapids, 0U);
  EXPECT_NEAR(difference->tip_mm, 1, 1e-12);
}

// The tip rests while the axis turns.
TEST(PathDifference, NamesATurnThatIsARapid) {
  const Vec3 tilted = Vec3(0.6, 0, 0.8);
  const Toolpath path =
      paths::through({paths::upright(0, 0, 0), paths::upright(10, 0, 0), {{10, 0, 0}, tilted}, {{20, 0, 0}, tilted}});
  const auto difference = measure_difference(path, with_rapid(path, 2), kHeight_mm, kWithin_mm);
  EXPECT_EQ(difference->rapids, 1U);
  EXPECT_EQ(difference->rapid_move, 2U);
}

TEST(PathDifference, AnAxisWithinATurnAtRestIsOnThePath) {
  const Vec3 tilted = Vec3(0.6, 0, 0.8);
  const Toolpath turn = paths::through({paths::upright(0, 0, 0), paths::upright(10, 0, 0), {{10, 0, 0}, tilted}});
  Toolpath in_two = turn;
  in_two.moves.insert(in_two.moves.begin() + 2, turn.moves[2]);
  in_two.moves[2].end.axis = (tilted + Vec3::UnitZ()).normalized();
  EXPECT_LT(measure_difference(in_two, turn, kHeight_mm, kWithin_mm)->axis_rad, 1e-9);
}

// A search that leaves out far blocks of feeds finds the same as one of all feeds.
TEST(PathDifference, FindsTheNearestOfManyFeeds) {
  std::vector<Pose> poses;
  for (int i = 0; i < 1500; ++i)
    poses.push_back(paths::upright(40 * std::sin(0.7 * i), 40 * std::cos(1.3 * i), 10 * std::sin(0.01 * i)));
  const Toolpath other = paths::through(poses);
  for (const int k : {0, 3, 700, 1400}) {
    const Pose place = paths::upright(k % 7, k % 11, 20);
    const auto found = measure_difference(paths::through({place}), other, kHeight_mm, kWithin_mm);
    double least_mm = 1e9;
    for (const MotionChord& feed : chords_of_feeds(other))
      least_mm = std::min(least_mm, distance_from(place, feed).tip_mm);
    EXPECT_EQ(found->tip_mm, least_mm);
  }
}

// A rapid along a feed that the other path has too is no difference.
TEST(PathDifference, AFeedBesideARapidOnTheSameWayIsNoRapid) {
  Toolpath there = paths::through({paths::upright(0, 0, 9), paths::upright(0, 0, 0), paths::upright(0, 0, 9),
                                   paths::upright(0, 0, 0), paths::upright(5, 0, 0)});
  there.moves[3].kind = MoveKind::rapid;
  Toolpath other = there;
  std::swap(other.moves[1].kind, other.moves[3].kind);
  EXPECT_EQ(measure_difference(there, other, kHeight_mm, kWithin_mm)->rapids, 0U);
}

TEST(PathDifference, APositionAloneIsNoFeedThatBecameARapid) {
  const Toolpath path = cut();
  Toolpath other = path;
  other.moves[0].kind = MoveKind::feed;
  other.moves[1].kind = MoveKind::rapid;
  Toolpath first_rapid = other;
  first_rapid.moves[0].kind = MoveKind::rapid;
  const auto difference = measure_difference(other, first_rapid, kHeight_mm, kWithin_mm);
  EXPECT_EQ(difference->rapids, 0U);
  EXPECT_EQ(difference->tip_mm, 0);
}

TEST(PathDifference, CountsMovesThatAreLeftOut) {
  Toolpath path = cut();
  path.moves[2].not_checked_reason = "a feed";
  path.moves[0].not_checked_reason = "a rapid";
  const MovesLeftOut out = count_left_out(path);
  EXPECT_EQ(out.feeds, 2U);
  EXPECT_EQ(out.unchecked, 2U);
  EXPECT_EQ(out.first_unchecked, 0U);
  EXPECT_EQ(out.first_unchecked_feed, 2U);
  EXPECT_EQ(out.rapids, 1U);
  EXPECT_EQ(out.first_rapid, 4U);
}

Toolpath finishing_passes() {
  std::vector<Pose> poses;
  for (int i = 0; i < 60; ++i) poses.push_back({{(i % 7) * 3.0, i * 0.5, (i % 3) * 0.2}, Vec3::UnitZ()});
  Toolpath path = paths::through(poses);
  for (Move& move : path.moves) move.kind = MoveKind::feed;
  return path;
}

TEST(PathRelation, FindsAFactorOfInchesAndAShift) {
  const Toolpath path = finishing_passes();
  EXPECT_FALSE(find_relation(path, path, kWithin_mm).has_value());
  Toolpath inches = path, shifted = path;
  for (Move& move : inches.moves) move.end.tip *= 25.4;
  for (Move& move : shifted.moves) move.end.tip += Vec3(10, 0, -5);
  EXPECT_EQ(find_relation(path, inches, kWithin_mm)->factor, 25.4);
  EXPECT_EQ(find_relation(inches, path, kWithin_mm)->factor, 1 / 25.4);
  const auto relation = find_relation(path, shifted, kWithin_mm);
  ASSERT_TRUE(relation.has_value());
  EXPECT_EQ(relation->factor, 1);
  EXPECT_LT((relation->shift_mm - Vec3(10, 0, -5)).norm(), 1e-12);
  shifted.moves[31].end.tip.z() += 0.01;
  EXPECT_FALSE(find_relation(path, shifted, kWithin_mm).has_value()) << "one position is not explained";
}

TEST(PathRelation, FindsAShiftWhereOnePathBeginsEarlier) {
  const Toolpath path = finishing_passes();
  Toolpath other = path;
  for (Move& move : other.moves) move.end.tip += Vec3(0, 0, 2);
  Move before = other.moves.front();
  before.end.tip += Vec3(1.5, 0.25, 0.5);
  other.moves.insert(other.moves.begin() + 1, before);
  EXPECT_FALSE(find_relation(path, other, 1e-3).has_value()) << "the position between is not on the other path";
  other.moves[1].end.tip = 0.5 * (other.moves[0].end.tip + other.moves[2].end.tip);
  EXPECT_TRUE(find_relation(path, other, 1e-3).has_value());
}

}  // namespace
}  // namespace gouge::path_difference_test

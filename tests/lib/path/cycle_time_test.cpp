#include "lib/path/cycle_time.h"

#include <gtest/gtest.h>

namespace gouge::cycle_time_test {
namespace {

Move move_to(double x, const Feed& feed, MoveKind kind = MoveKind::feed, std::size_t operation = 0) {
  Move move;
  move.end = {Vec3(x, 0, 0), Vec3::UnitZ()};
  move.has_start = true;
  move.kind = kind;
  move.operation = operation;
  move.set_feed(feed);
  return move;
}

constexpr Feed kFast{600, FeedUnit::per_minute}, kRapid{0, FeedUnit::rapid};

Toolpath path_with(const std::vector<Move>& moves) {
  Toolpath path;
  path.operations = {{"A", 1}, {"B", 9}};
  path.moves.push_back(move_to(0, kRapid, MoveKind::rapid));
  path.moves[0].has_start = false;
  for (const Move& move : moves) path.moves.push_back(move);
  return path;
}

TEST(CycleTime, IsLengthByFeedInEachOperation) {
  const Toolpath path = path_with({move_to(100, kFast), move_to(400, {1200, FeedUnit::per_minute}, MoveKind::feed, 1),
                                   move_to(410, kFast, MoveKind::feed, kNone)});
  const std::vector<CycleTime> times = measure_cycle_times(path);
  ASSERT_EQ(times.size(), 3U);
  EXPECT_DOUBLE_EQ(times[0].feed_seconds, 10);
  EXPECT_DOUBLE_EQ(times[1].feed_seconds, 15);
  EXPECT_DOUBLE_EQ(times[2].feed_seconds, 1);
  EXPECT_DOUBLE_EQ(times[1].feed_mm, 300);
  EXPECT_EQ(times[0].moves_without_start, 1U);
  EXPECT_FALSE(times[0].is_whole());
  EXPECT_TRUE(times[1].is_whole());
}

TEST(CycleTime, LeavesOutRapidsAndRetractsOfCycles) {
  const CycleTime time =
      measure_cycle_times(path_with({move_to(50, kRapid, MoveKind::rapid), move_to(20, kFast, MoveKind::cycle),
                                     move_to(40, kRapid, MoveKind::cycle)}))[0];
  EXPECT_EQ(time.rapids, 2U);
  EXPECT_DOUBLE_EQ(time.rapid_mm, 70);
  EXPECT_DOUBLE_EQ(time.feed_seconds, 3);
}

TEST(CycleTime, CountsMovesWhoseTimeIsNotKnown) {
  Move joints = move_to(40, kFast);
  joints.runs_joints = true;
  const CycleTime time = measure_cycle_times(
      path_with({move_to(10, {0.1, FeedUnit::per_revolution}), move_to(20, {0, FeedUnit::not_stated}),
                 move_to(30, {0, FeedUnit::not_understood}), joints}))[0];
  EXPECT_EQ(time.moves_per_turn, 1U);
  EXPECT_EQ(time.moves_without_feed, 3U);
  EXPECT_DOUBLE_EQ(time.open_mm, 40);
  EXPECT_EQ(time.feed_seconds, 0);
}

}  // namespace
}  // namespace gouge::cycle_time_test

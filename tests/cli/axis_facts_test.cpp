#include "cli/job/setup_notes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gouge::axis_facts_test {
namespace {

Move feed_to(double x, double angle_rad) {
  Move move;
  move.end = {Vec3(x, 0, 0), Vec3(0, std::sin(angle_rad), std::cos(angle_rad))};
  move.has_start = x > 0;
  move.set_feed({60, FeedUnit::per_minute});
  return move;
}

TEST(AxisFacts, GoByTheMovesThatEachMoveBecame) {
  Toolpath before;
  for (const double x : {0.0, 10.0, 20.0, 30.0}) before.moves.push_back(feed_to(x, 0));
  PathChange change;
  change.move = 2;
  change.inserted_before = {feed_to(12, 0.1).end, feed_to(15, 0.1).end};
  change.new_end = feed_to(20, 0.2).end;
  Toolpath after = before;
  after.moves[2].end = *change.new_end;
  after.moves.insert(after.moves.begin() + 2, {feed_to(12, 0.1), feed_to(15, 0.1)});
  const AxisFacts facts = measure_axes(before, {change}, after, 60.0);
  EXPECT_FALSE(facts.before.has_turns());
  EXPECT_EQ(facts.tilts.positions, 3U);
  EXPECT_NEAR(facts.tilts.tilt_rad.value, 0.2, 1e-12);
  EXPECT_EQ(facts.tilts.tilt_rad.move, 4U);
  EXPECT_NEAR(facts.after.turn_rad_per_mm.value, 0.05, 1e-12) << "0.1 rad in the 2 mm to the first inserted position";
  EXPECT_NEAR(facts.after.feed_seconds, 30, 1e-12);
  // A degree a second: 5.73 s for each 0.1 rad, in moves of 2, 3, 5 and 10 s.
  const double tenth = 18 / std::acos(-1);
  EXPECT_NEAR(facts.after.limited_feed_seconds.value_or(0), 10 + tenth + 3 + tenth + 2 * tenth, 1e-9);
  EXPECT_TRUE(facts.is_of_interest());
  EXPECT_FALSE(measure_axes(before, {}, before, {}).is_of_interest());
  EXPECT_TRUE(measure_axes({}, {}, {}, {}).tilts.runs.empty());
}

TEST(AxisFacts, AreThoseOfNoPairsWhereThePathsDoNotMatch) {
  Toolpath before;
  for (const double x : {0.0, 10.0}) before.moves.push_back(feed_to(x, 0));
  Toolpath after = before;
  after.moves.push_back(feed_to(20, 0.3));
  EXPECT_EQ(measure_axes(before, {}, after, {}).tilts.positions, 0U);
}

TEST(RotaryLimit, IsDegreesAMinuteOrNone) {
  EXPECT_FALSE(understand_rotary_limit("").value().has_value());
  EXPECT_EQ(understand_rotary_limit("3600").value(), RotaryLimit(3600));
  EXPECT_FALSE(understand_rotary_limit("0.0001").has_value());
}

}  // namespace
}  // namespace gouge::axis_facts_test

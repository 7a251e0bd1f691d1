#include "lib/path/axis_quality.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace gouge::axis_quality_test {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

Vec3 leaning(double angle_rad) { return {std::sin(angle_rad), 0, std::cos(angle_rad)}; }

Move feed_to(const Vec3& tip, const Vec3& axis, double feed_mm = 600) {
  Move move;
  move.end = {tip, axis};
  move.has_start = true;
  if (feed_mm > 0) move.set_feed({feed_mm, FeedUnit::per_minute});
  return move;
}

// Straight along X with the axis leaning by angles[i] at x[i].
Toolpath path_of(const std::vector<double>& x, const std::vector<double>& angles) {
  Toolpath path;
  for (std::size_t i = 0; i < x.size(); ++i) path.moves.push_back(feed_to(Vec3(x[i], 0, 0), leaning(angles[i])));
  path.moves[0].has_start = false;
  return path;
}

TEST(AxisQuality, OfAnAxisThatStandsIsNothing) {
  const AxisQuality quality = measure_axis_quality(path_of({0, 1, 5}, {0.3, 0.3, 0.3}));
  EXPECT_FALSE(quality.has_turns());
  EXPECT_EQ(quality.turn_rad_per_mm.move, kNone);
  EXPECT_EQ(quality.bending, 0);
  EXPECT_FALSE(measure_axis_quality({}).has_turns());
}

TEST(AxisQuality, OfOneKinkIsThatOfItsFormula) {
  // The axis represents 2 mm, then leans by 1 degree over 0.5 mm: |du| is the chord 2 sin(0.5 deg).
  const AxisQuality quality = measure_axis_quality(path_of({0, 2, 2.5}, {0, 0, kDegree}));
  const double slope = 2 * std::sin(kDegree / 2) / 0.5;
  EXPECT_NEAR(quality.bending, slope * slope * 2 / 2.5, 1e-15);
  EXPECT_NEAR(quality.turn_rad_per_mm.value, 2 * kDegree, 1e-12);
  EXPECT_EQ(quality.turn_rad_per_mm.move, 2U);
  EXPECT_NEAR(quality.turn_rad.value, kDegree, 1e-12);
}

TEST(AxisQuality, OfAnEvenTurnIsTheCurvatureOfTheSphereAlone) {
  // w = 0.01 rad/mm over 100 mm: u'' is w^2 towards the centre of the sphere, so J is w^4 * 100 in the limit.
  for (const int count : {100, 400}) {
    std::vector<double> x, angles;
    for (int i = 0; i <= count; ++i) {
      x.push_back(100.0 * i / count);
      angles.push_back(1.0 * i / count);
    }
    const double step = 100.0 / count, turn = 1.0 / count;
    const double at_one = std::pow(4 * std::pow(std::sin(turn / 2), 2) / step, 2) / step;
    const AxisQuality quality = measure_axis_quality(path_of(x, angles));
    EXPECT_NEAR(quality.bending, (count - 1) * at_one, 1e-15);
    EXPECT_NEAR(quality.bending, 1e-6, 1.1e-8);
    EXPECT_NEAR(quality.turn_rad_per_mm.value, 0.01, 1e-12);
  }
}

TEST(AxisQuality, SeesAKinkAcrossTheTurn) {
  // As fast before and behind, but about another axis: the rate keeps its size and not its direction.
  Toolpath path = path_of({0, 1, 2}, {-0.01, 0, 0});
  path.moves[2].end.axis = Vec3(0, std::sin(0.01), std::cos(0.01));
  EXPECT_NEAR(measure_axis_quality(path).bending, 2 * 1e-4, 1e-8);
}

TEST(AxisQuality, CountsTurnsOnTheSpotApart) {
  const AxisQuality quality = measure_axis_quality(path_of({0, 1, 1, 2}, {0, 0, 0.5, 0.5}));
  EXPECT_EQ(quality.turns_on_the_spot, 1U);
  EXPECT_NEAR(quality.turn_on_the_spot_rad.value, 0.5, 1e-12);
  EXPECT_EQ(quality.turn_on_the_spot_rad.move, 2U);
  EXPECT_NEAR(quality.turn_rad.value, 0.5, 1e-12);
  EXPECT_LT(quality.turn_rad_per_mm.value, 1e-12);
  EXPECT_EQ(quality.bending, 0) << "J ends before the turn and begins anew behind it";
}

TEST(AxisQuality, AMoveOfNoLengthAndNoTurnIsPassedOver) {
  const double with = measure_axis_quality(path_of({0, 1, 1, 2}, {0, 0, 0, 0.1})).bending;
  EXPECT_GT(with, 0);
  EXPECT_EQ(with, measure_axis_quality(path_of({0, 1, 2}, {0, 0, 0.1})).bending);
}

TEST(AxisQuality, RapidsAndGapsEndARun) {
  Toolpath path = path_of({0, 1, 2, 3}, {0, 0, 0.4, 0.4});
  path.moves[2].kind = MoveKind::rapid;
  EXPECT_EQ(measure_axis_quality(path).bending, 0);
  EXPECT_FALSE(measure_axis_quality(path).has_turns()) << "the axis may turn as it likes in a rapid";
  path.moves[2].kind = MoveKind::feed;
  path.moves[2].has_start = false;
  EXPECT_EQ(measure_axis_quality(path).bending, 0);
  path.moves[2].has_start = true;
  path.moves[2].kind = MoveKind::cycle;
  path.moves[2].set_feed({0, FeedUnit::rapid});
  EXPECT_FALSE(measure_axis_quality(path).has_turns()) << "a step of a cycle at rapid speed";
}

TEST(AxisQuality, TakesTheLengthOfTheCurve) {
  Toolpath path;
  path.moves = {feed_to(Vec3(10, 0, 0), Vec3::UnitZ()), feed_to(Vec3(-10, 0, 0), leaning(0.1))};
  path.moves[0].has_start = false;
  path.moves[1].kind = MoveKind::arc;
  path.moves[1].curve_kind = CurveKind::arc;
  path.arcs.push_back({Vec3::Zero(), Vec3::UnitZ(), std::numbers::pi});
  const AxisQuality quality = measure_axis_quality(path);
  EXPECT_NEAR(quality.turn_rad_per_mm.value, 0.1 / (10 * std::numbers::pi), 1e-12);
  EXPECT_NEAR(quality.feed_seconds, std::numbers::pi, 1e-12);
}

TEST(FeedTime, IsLengthByFeedAndNoFasterThanTheRotaryLimit) {
  // 10 mm at 600 mm/min is 1 s; a turn of 0.2 rad at 0.1 rad/s is 2 s; a turn on the spot takes its turn alone.
  Toolpath path = path_of({0, 10, 20, 20}, {0, 0.2, 0.2, 0.5});
  EXPECT_NEAR(measure_axis_quality(path).feed_seconds, 2, 1e-12);
  EXPECT_FALSE(measure_axis_quality(path).limited_feed_seconds.has_value());
  EXPECT_NEAR(measure_axis_quality(path, 0.1).limited_feed_seconds.value_or(0), 2 + 1 + 3, 1e-12);
  EXPECT_NEAR(measure_axis_quality(path, 100.0).limited_feed_seconds.value_or(0), 2.003, 1e-12);
  path.moves[1].set_feed({0.1, FeedUnit::per_revolution});
  path.moves[3].set_feed({});
  const AxisQuality quality = measure_axis_quality(path, 0.1);
  EXPECT_EQ(quality.moves_without_feed, 2U);
  EXPECT_NEAR(quality.feed_seconds, 1, 1e-12);
  EXPECT_NEAR(quality.limited_feed_seconds.value_or(0), 1, 1e-12);
}

}  // namespace
}  // namespace gouge::axis_quality_test

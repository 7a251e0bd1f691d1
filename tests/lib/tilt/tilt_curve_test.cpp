#include "lib/tilt/tilt_curve.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/scatter.h"

namespace gouge::tilt_curve_test {
namespace {

std::vector<double> even_ways(std::size_t count, double step) {
  std::vector<double> ways;
  for (std::size_t i = 0; i < count; ++i) ways.push_back(static_cast<double>(i) * step);
  return ways;
}

TEST(TiltCurve, GoesThroughItsAnchorsAndIsLevelWhereAsked) {
  const std::vector<double> ways = even_ways(2001, 0.01);
  const std::vector<TiltAnchor> anchors{
      {0, Tilt::Zero()}, {500, Tilt(0.2, 0.1)}, {900, Tilt(0.1, 0.3)}, {2000, Tilt::Zero()}};
  const TiltSequence level = curve_through(anchors, ways, true, true);
  for (const TiltAnchor& anchor : anchors) EXPECT_EQ(level[anchor.position], anchor.tilt);
  EXPECT_LT(level[1].norm(), 2e-5);
  EXPECT_LT(level[1999].norm(), 2e-5);
  const TiltSequence open = curve_through(anchors, ways, false, false);
  EXPECT_GT(open[1].norm(), 2e-4);
  EXPECT_LT((open[0] - 2 * open[1] + open[2]).norm(), 1e-6);
}

TEST(TiltCurve, IsTheSmoothestThroughItsAnchors) {
  test::Scatter random(2);
  const std::vector<double> ways = even_ways(401, 0.1);
  for (int n = 0; n < 20; ++n) {
    std::vector<TiltAnchor> anchors{{0, Tilt::Zero()}};
    for (std::size_t at = 20 + random.below(60); at < 400; at += 20 + random.below(60))
      anchors.push_back({at, Tilt(random.in(-1, 1), random.in(-1, 1))});
    anchors.push_back({400, Tilt::Zero()});
    const TiltSequence curve = curve_through(anchors, ways, true, true);
    const double least = roughness(curve, ways);
    for (int k = 0; k < 20; ++k) {
      // A bump between two anchors, level at both: another curve through all of them, and rougher, but for the ends,
      // of whose curvature the sum leaves out a half.
      const std::size_t a = random.below(anchors.size() - 1);
      const std::size_t from = anchors[a].position, to = anchors[a + 1].position;
      TiltSequence other = curve;
      const Tilt most(random.in(-0.3, 0.3), random.in(-0.3, 0.3));
      for (std::size_t i = from; i <= to; ++i) {
        const double u = static_cast<double>(i - from) / static_cast<double>(to - from);
        other[i] += 16 * u * u * (1 - u) * (1 - u) * most;
      }
      EXPECT_GT(roughness(other, ways), 0.97 * least);
    }
  }
}

TEST(TiltCurve, RoughnessIsThatOfTheIntegral) {
  // w = s^3 from 0 to 1: the integral of (6 s)^2 is 12.
  const std::vector<double> ways = even_ways(10'001, 1e-4);
  TiltSequence tilts;
  for (const double s : ways) tilts.emplace_back(s * s * s, 0);
  EXPECT_NEAR(roughness(tilts, ways), 12, 0.01);
  // One kink of 0.1 rad/mm between pieces of 2 and 3 mm.
  EXPECT_NEAR(roughness({Tilt(0, 0), Tilt(0, 0), Tilt(0.3, 0)}, {0, 2, 5}), 0.01 * 2 / 5, 1e-12);
}

TEST(TiltCurve, OfPositionsAtOnePlaceHasOneValue) {
  const std::vector<double> ways{0, 1, 1, 2, 3};
  const TiltSequence curve = curve_through({{0, Tilt::Zero()}, {1, Tilt(1, 0)}, {4, Tilt::Zero()}}, ways, true, true);
  EXPECT_EQ(curve[1], curve[2]);
  for (const Tilt& tilt : curve) EXPECT_TRUE(tilt.allFinite());
}

}  // namespace
}  // namespace gouge::tilt_curve_test

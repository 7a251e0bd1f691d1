#include "lib/verify/bounds.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/scatter.h"

namespace gouge::bounds_test {
namespace {

TEST(SineCosine, HoldTheTrueValuesCloselyAtAllAnglesThatAreAskedFor) {
  const RoundsUpward upward;
  for (double angle = -6.5; angle <= 6.5; angle += 0.0173) {
    const SineCosine found = sine_cosine(Bounds(angle));
    EXPECT_TRUE(found.sine.inf() <= std::sin(angle) && std::sin(angle) <= found.sine.sup()) << angle;
    EXPECT_TRUE(found.cosine.inf() <= std::cos(angle) && std::cos(angle) <= found.cosine.sup()) << angle;
    EXPECT_LE(found.sine.sup() - found.sine.inf(), 1e-12) << angle;
  }
}

// r <= sqrt(x) where r r - x <= 0, whose sign fma shows however it rounds.
TEST(SquareRoot, HoldsTheTrueRootWithinTwoSteps) {
  const RoundsUpward upward;
  test::Scatter scatter(20261125);
  for (int i = 0; i < 100'000; ++i) {
    const double x = std::ldexp(scatter.in(1, 2), static_cast<int>(scatter.below(600)) - 300);
    const Bounds root = square_root(Bounds(x));
    EXPECT_LE(std::fma(root.inf(), root.inf(), -x), 0) << x;
    EXPECT_GE(std::fma(root.sup(), root.sup(), -x), 0) << x;
    EXPECT_LE(root.sup() - root.inf(), 0x1p-50 * root.sup()) << x;
  }
}

TEST(SquareRoot, OfWhatRoundingMadeNegativeIsZero) {
  const RoundsUpward upward;
  EXPECT_EQ(square_root(Bounds(-1e-17)).sup(), 0);
  const Bounds root = square_root(Bounds(-1e-17, 4));
  EXPECT_EQ(root.inf(), 0);
  EXPECT_EQ(root.sup(), 2);
}

}  // namespace
}  // namespace gouge::bounds_test

#include "lib/overcut/cell_program.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/support/scatter.h"

namespace gouge::cell_program_test {
namespace {

Vec4 random_vector(test::Scatter& random) {
  return {random.in(-1, 1), random.in(-1, 1), random.in(-1, 1), random.in(-1, 1)};
}

TEST(CellProgram, OfABoxAloneIsAtItsCorner) {
  CellProgram program(Vec4(1, 2, 3, 0.5));
  program.limit({10, Vec4(1, -1, 2, 0)});
  EXPECT_DOUBLE_EQ(program.bound().upper, 10 + 1 + 2 + 6);
}

TEST(CellProgram, TakesTheCornerBetweenTwoPlanes) {
  // Below z = -|x|, up to z: the largest height is 0, and each plane alone allows 1.
  CellProgram program(Vec4(1, 1, 5, 0.5));
  program.limit({0, Vec4(0, 0, 1, 0)});
  program.keep_behind({0, Vec4(1, 0, -1, 0)});
  EXPECT_NEAR(program.bound().upper, 1, 1e-12);
  program.keep_behind({0, Vec4(-1, 0, -1, 0)});
  EXPECT_NEAR(program.bound().upper, 0, 1e-12);
}

TEST(CellProgram, IsEmptyWherePlanesMissTheBoxOnlyTogether) {
  CellProgram program(Vec4(1, 1, 1, 0.5));
  program.limit({0, Vec4(0, 0, 1, 0)});
  program.keep_behind({-0.6, Vec4(1, 1, 0, 0)});
  EXPECT_GT(program.bound().upper, -1e300);
  program.keep_behind({-0.6, Vec4(-1, -1, 0, 0)});
  EXPECT_EQ(program.bound().upper, -std::numeric_limits<double>::infinity());
}

TEST(CellProgram, LeavesOfTheBoxWhatIsHighEnough) {
  // Below a roof of height 3 with slopes of 1: half a unit to each side is higher than 2.5.
  CellProgram program(Vec4(2, 1, 1, 0.5));
  program.limit({3, Vec4(1, 0, 0, 0)});
  program.limit({3, Vec4(-1, 0, 0, 0)});
  const CellProgram::Range range = program.where_at_least(2.5, program.bound());
  EXPECT_NEAR(range.low[0], -0.5, 1e-8);
  EXPECT_NEAR(range.high[0], 0.5, 1e-8);
  EXPECT_EQ(range.low[1], -1);
}

TEST(CellProgram, BlendsTwoLimits) {
  // Below both slopes of a roof.
  CellProgram program(Vec4(1, 1, 1, 0.5));
  program.limit({3, Vec4(1, 0, 0, 0)});
  program.limit({3, Vec4(-1, 0, 0, 0)});
  EXPECT_NEAR(program.bound().upper, 3, 1e-12);
}

TEST(CellProgram, IsNeverBelowAnyPoint) {
  test::Scatter random(3);
  std::size_t feasible = 0, near = 0, above = 0;
  for (int k = 0; k < 2000; ++k) {
    const Vec4 half(random.in(0.1, 1), random.in(0.1, 1), random.in(0.1, 1), 0.5);
    CellProgram program(half);
    std::vector<Affine> planes, limits;
    const std::size_t plane_count = random.below(4), limit_count = 1 + random.below(2);
    for (std::size_t n = 0; n < plane_count; ++n) planes.push_back({random.in(-0.3, 0.3), random_vector(random)});
    for (std::size_t n = 0; n < limit_count; ++n) limits.push_back({random.in(-1, 1), random_vector(random)});
    for (const Affine& plane : planes) program.keep_behind(plane);
    for (const Affine& limit : limits) program.limit(limit);
    const CellProgram::Bound bound = program.bound();
    const double upper = bound.upper;
    const double least = random.in(-1, 1);
    const CellProgram::Range range = program.where_at_least(least, bound);
    double best = -1e300;
    for (int n = 0; n < 300; ++n) {
      Vec4 y = random_vector(random).cwiseProduct(half);
      if (n % 3 == 0) y = y.cwiseSign().cwiseProduct(half);
      if (n == 1) y = bound.at;
      const bool is_kept = std::all_of(planes.begin(), planes.end(), [&](const Affine& p) { return p.at(y) >= 0; });
      if (!is_kept) continue;
      double value = 1e300;
      for (const Affine& limit : limits) value = std::min(value, limit.at(y));
      best = std::max(best, value);
      if (value < least) continue;
      ++above;
      EXPECT_GE((y - range.low).minCoeff(), -1e-12) << k;
      EXPECT_GE((range.high - y).minCoeff(), -1e-12) << k;
    }
    if (best > -1e300) {
      ++feasible;
      EXPECT_LE(best, upper + 1e-12) << k;
    }
    near += best > upper - 0.2 ? 1U : 0U;
  }
  EXPECT_GT(feasible, 1000U);
  EXPECT_GT(near, 500U);
  EXPECT_GT(above, 1000U);
}

}  // namespace
}  // namespace gouge::cell_program_test

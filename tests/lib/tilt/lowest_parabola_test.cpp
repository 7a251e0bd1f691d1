#include "lib/tilt/lowest_parabola.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "tests/support/scatter.h"

namespace gouge::lowest_parabola_test {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

std::vector<Tilt> some_tilts(test::Scatter& random) {
  std::vector<Tilt> tilts;
  const bool is_lattice = random.is(0.7);
  const std::size_t count = random.below(40);
  for (std::size_t k = 0; k < count; ++k) {
    if (is_lattice) {
      tilts.push_back(0.1 * Tilt(static_cast<double>(random.below(7)), static_cast<double>(random.below(7))));
    } else {
      tilts.emplace_back(random.in(0, 0.6), random.in(0, 0.6));
    }
  }
  return tilts;
}

TEST(LowestParabolas, AreThoseOfAllThatAreAsked) {
  test::Scatter random(53);
  LowestParabolas parabolas;
  std::size_t none = 0, found = 0;
  for (int n = 0; n < 3000; ++n) {
    const std::vector<Tilt> from = some_tilts(random), to = some_tilts(random);
    const double steepness = random.is(0.2) ? 1000 : random.in(0.1, 10), missing = random.in(0, 1);
    std::vector<double> heights;
    for (std::size_t k = 0; k < from.size(); ++k)
      heights.push_back(random.is(missing) ? kNever : random.is(0.3) ? 0 : random.in(0, 0.5));
    const auto value = [&](std::size_t a, std::size_t b) {
      return heights[a] + steepness * (to[b] - from[a]).squaredNorm();
    };
    const std::vector<std::uint32_t>& lowest = parabolas.find(TiltRows(from), heights, steepness, TiltRows(to));
    ASSERT_EQ(lowest.size(), to.size());
    for (std::size_t b = 0; b < to.size(); ++b) {
      double least = kNever;
      for (std::size_t a = 0; a < from.size(); ++a) least = std::min(least, value(a, b));
      const bool is_none = lowest[b] == LowestParabolas::kNoTilt;
      ASSERT_EQ(is_none, !(least < kNever)) << n;
      (is_none ? none : found)++;
      if (!is_none) {
        ASSERT_NEAR(value(lowest[b], b), least, 1e-12 * (1 + least)) << n;
      }
    }
  }
  EXPECT_GT(none, 1000U);
  EXPECT_GT(found, 10'000U);
}

}  // namespace
}  // namespace gouge::lowest_parabola_test

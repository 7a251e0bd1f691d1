#include "lib/correct/clean_intervals.h"
#include "tests/support/motions.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace gouge::clean_intervals_test {
namespace {

struct Search {
  std::vector<TimeInterval> found;
  int calls = 0;
};

/// A motion along X of this length, which gouges in these open time intervals.
Search search(double length_mm, const std::vector<TimeInterval>& gouges) {
  const Motion motion = test::straight({Vec3(0, 0, 0), Vec3::UnitZ()}, {Vec3(length_mm, 0, 0), Vec3::UnitZ()});
  Search search;
  search.found = find_clean_intervals(motion, [&](double first, double last) {
    ++search.calls;
    return std::none_of(gouges.begin(), gouges.end(),
                        [&](const TimeInterval& g) { return first < g.last && last > g.first; });
  });
  return search;
}

TEST(CleanIntervals, ACleanMotionIsOneIntervalAndOneQuestion) {
  const Search all = search(40, {});
  ASSERT_EQ(all.found.size(), 1U);
  EXPECT_EQ(all.found[0].first, 0);
  EXPECT_EQ(all.found[0].last, 1);
  EXPECT_EQ(all.calls, 1);
}

TEST(CleanIntervals, EndWhereTheGougesBeginToAHundredthOfAMillimetre) {
  const std::vector<TimeInterval> gouges{{0.1234, 0.1236}, {0.3, 0.45}, {0.71, 1.1}};
  const Search all = search(40, gouges);
  ASSERT_EQ(all.found.size(), 3U);
  EXPECT_EQ(all.found[0].first, 0);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_LE(all.found[k].last, gouges[k].first);
    EXPECT_NEAR(all.found[k].last, gouges[k].first, 0.01 / 40);
    if (k == 0) continue;
    EXPECT_GE(all.found[k].first, gouges[k - 1].last);
    EXPECT_NEAR(all.found[k].first, gouges[k - 1].last, 0.01 / 40);
  }
}

TEST(CleanIntervals, AShortOneIsFoundAtTheEndsOfTheMotion) {
  const Search all = search(40, {{0.001, 0.998}});
  ASSERT_EQ(all.found.size(), 2U);
  EXPECT_NEAR(all.found[0].last, 0.001, 0.01 / 40);
  EXPECT_NEAR(all.found[1].first, 0.998, 0.01 / 40);
}

TEST(CleanIntervals, NoneIsFoundInAMotionThatGougesAllTheWayAndItCostsLittle) {
  const Search all = search(40, {{-1, 2}});
  EXPECT_TRUE(all.found.empty());
  EXPECT_LE(all.calls, 65);
  EXPECT_LE(search(0.5, {{-1, 2}}).calls, 5);
}

}  // namespace
}  // namespace gouge::clean_intervals_test

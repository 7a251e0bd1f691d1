#include "cli/batch/job_dealer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

#include "tests/support/scatter.h"

namespace gouge::job_dealer_test {
namespace {

using Positions = std::vector<std::size_t>;

// As much work at every position.
JobDealer even_dealer(const Positions& group_ends, std::size_t processes) {
  return JobDealer(group_ends, std::vector<std::uint64_t>(group_ends.empty() ? 0 : group_ends.back(), 1), processes);
}

TEST(JobDealer, GivesOneProcessAllInOrder) {
  JobDealer dealer = even_dealer({3, 4, 9}, 1);
  Positions taken;
  for (auto block = dealer.take(0, 2); block.count > 0; block = dealer.take(0, 2)) {
    for (std::size_t k = 0; k < block.count; ++k) taken.push_back(block.first + k);
  }
  EXPECT_EQ(taken, (Positions{0, 1, 2, 3, 4, 5, 6, 7, 8}));
}

TEST(JobDealer, GivesNothingOfNoList) {
  EXPECT_EQ(JobDealer().take(0, 1).count, 0U);
  EXPECT_EQ(even_dealer({}, 3).take(2, 5).count, 0U);
}

TEST(JobDealer, LetsAProcessStayInItsGroup) {
  JobDealer dealer = even_dealer({4, 8}, 2);
  EXPECT_EQ(dealer.take(0, 1).first, 0U);
  EXPECT_EQ(dealer.take(1, 1).first, 4U);
  EXPECT_EQ(dealer.take(0, 1).first, 1U);
  EXPECT_EQ(dealer.take(1, 1).first, 5U);
}

TEST(JobDealer, GivesTheLaterHalfOfTheLongestRestToWhoHasNone) {
  JobDealer dealer = even_dealer({10, 11}, 3);
  EXPECT_EQ(dealer.take(0, 1).first, 0U);
  EXPECT_EQ(dealer.take(1, 1).first, 10U);
  EXPECT_EQ(dealer.take(2, 1).first, 5U);  // of 1 to 9
  EXPECT_EQ(dealer.take(1, 9).first, 3U);  // of 1 to 4, as 6 to 9 is as long and of a later process
}

TEST(JobDealer, HalvesByWorkNotByCount) {
  JobDealer dealer({6, 10}, {9, 8, 4, 3, 2, 2, 1, 1, 1, 1}, 3);
  EXPECT_EQ(dealer.take(0, 1).first, 0U);
  EXPECT_EQ(dealer.take(1, 1).first, 6U);
  EXPECT_EQ(dealer.take(2, 1).first, 2U);  // of 8, 4, 3, 2, 2
  EXPECT_EQ(dealer.take(0, 1).first, 1U);
  EXPECT_EQ(dealer.take(0, 1).first, 4U);  // of 3, 2, 2
}

TEST(JobDealer, NeverGivesMoreOfAGroupThanAskedFor) {
  JobDealer dealer = even_dealer({5, 7}, 1);
  EXPECT_EQ(dealer.take(0, 4).count, 4U);
  EXPECT_EQ(dealer.take(0, 4).count, 1U);
  EXPECT_EQ(dealer.take(0, 4).count, 2U);
  EXPECT_EQ(dealer.take(0, 4).count, 0U);
}

// Processes of random speeds: each position once, and few read the same scene.
TEST(JobDealer, GivesEachPositionOnceAndHasFewReadTheSameScene) {
  test::Scatter random(7);
  for (int round = 0; round < 300; ++round) {
    const std::size_t processes = 1 + random.below(9), groups = 1 + random.below(30);
    Positions ends;
    for (std::size_t group = 0, end = 0; group < groups; ++group) ends.push_back(end += 1 + random.below(60));
    std::vector<std::uint64_t> work;
    for (std::size_t position = 0; position < ends.back(); ++position) work.push_back(1 + random.below(4));
    JobDealer dealer(ends, work, processes);
    std::vector<double> free_at(processes, 0.0);
    std::vector<int> given(ends.back(), 0);
    std::set<std::pair<std::size_t, std::size_t>> readings;
    for (;;) {
      const auto process = static_cast<std::size_t>(std::ranges::min_element(free_at) - free_at.begin());
      const JobDealer::Block block = dealer.take(process, 1 + random.below(4));
      if (block.count == 0) break;
      for (std::size_t position = block.first; position < block.first + block.count; ++position) {
        ++given[position];
        const auto group = static_cast<std::size_t>(std::ranges::upper_bound(ends, position) - ends.begin());
        readings.emplace(process, group);
        free_at[process] += random.in(0.5, 1.5) * static_cast<double>(work[position]);
      }
    }
    EXPECT_TRUE(std::ranges::all_of(given, [](int times) { return times == 1; }));
    // A process takes over at most as often as rests halve to nothing.
    EXPECT_LE(readings.size(), groups + processes * 12);
  }
}

}  // namespace
}  // namespace gouge::job_dealer_test

#include "lib/base/best_first_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace gouge::best_first_search_test {
namespace {

constexpr double kSlope = 9;

double height(double x) { return std::sin(3 * x) + 0.5 * std::sin(11 * x + 1); }

struct Interval : SearchCandidate {
  double low = 0, high = 0;
};

/// The largest height over [0, 4], by the slope.
template <bool kIsDescending>
class Hill : public BestFirstSearch<Hill<kIsDescending>, Interval> {
 public:
  static constexpr bool kDescends = kIsDescending;

  explicit Hill(const SearchGoal& goal) : goal_(goal) {}

  double find(double pruned = 0) {
    this->prune(pruned);
    add(0, 4);
    return std::max(this->run(), value_);
  }

  [[nodiscard]] double threshold_mm() const { return goal_.pruning_threshold_mm(value_); }
  [[nodiscard]] bool is_exhausted() const { return bounds_ >= goal_.budget; }
  [[nodiscard]] bool was_decided() const { return this->is_decided(); }
  [[nodiscard]] double value() const { return value_; }
  [[nodiscard]] const std::vector<double>& order() const { return order_; }

  void split(const Interval& whole) {
    order_.push_back(whole.upper_mm);
    const double middle = 0.5 * (whole.low + whole.high);
    add(whole.low, middle);
    add(middle, whole.high);
  }

 private:
  void add(double low, double high) {
    ++bounds_;
    Interval interval;
    interval.low = low;
    interval.high = high;
    const double at_middle = height(0.5 * (low + high));
    value_ = std::max(value_, at_middle);
    interval.upper_mm = at_middle + 0.5 * kSlope * (high - low);
    this->offer(interval);
  }

  SearchGoal goal_;
  double value_ = 0;
  std::uint64_t bounds_ = 0;
  std::vector<double> order_;
};

double sampled_maximum() {
  double most = 0;
  for (int i = 0; i <= 400000; ++i) most = std::max(most, height(1e-5 * i));
  return most;
}

template <typename Search>
void expect_enclosure(const SearchGoal& goal, double maximum) {
  Search search(goal);
  const double upper = search.find();
  EXPECT_LE(search.value(), maximum + 1e-9) << goal.budget;
  EXPECT_GE(upper, maximum) << goal.budget;
  if (!search.was_decided()) return;
  if (search.value() > goal.tolerance_mm) {
    EXPECT_LE(upper, search.value() + goal.gap_mm);
  } else {
    EXPECT_LE(upper, goal.tolerance_mm + goal.resolution_mm);
  }
}

TEST(BestFirstSearch, EnclosesTheMaximumAtAnyBudget) {
  const double maximum = sampled_maximum();
  for (const std::uint64_t budget : {0U, 1U, 2U, 3U, 5U, 10U, 30U, 100U, 1000U, 100000U}) {
    for (const double tolerance : {0.0, 1.0, 2.0}) {
      const SearchGoal goal{tolerance, 0.01, 0.001, budget};
      expect_enclosure<Hill<true>>(goal, maximum);
      expect_enclosure<Hill<false>>(goal, maximum);
    }
  }
  Hill<false> whole({0, 0.01, 0.001, 100000});
  EXPECT_LE(whole.find(), maximum + 0.001);
  EXPECT_TRUE(whole.was_decided());
  Hill<false> cut_short({0, 0.01, 0.001, 10});
  EXPECT_GT(cut_short.find(), maximum + 0.001);
  EXPECT_FALSE(cut_short.was_decided());
}

TEST(BestFirstSearch, CountsWhatWasProvedBefore) {
  Hill<true> search({0, 0.01, 0.001, 100000});
  EXPECT_GE(search.find(5), 5);
}

TEST(BestFirstSearch, SplitsTheLargestBoundFirst) {
  Hill<false> search({0, 0.01, 0.001, 100000});
  (void)search.find();
  EXPECT_GT(search.order().size(), 20U);
  EXPECT_TRUE(std::is_sorted(search.order().rbegin(), search.order().rend()));
}

/// Parts of equal bounds.
class Ties : public BestFirstSearch<Ties, Interval> {
 public:
  static constexpr bool kDescends = false;

  void find() {
    for (int i = 0; i < 20; ++i) {
      Interval interval;
      interval.upper_mm = 1;
      interval.low = i;
      offer(interval);
    }
    (void)run();
  }
  [[nodiscard]] static double threshold_mm() { return 0; }
  [[nodiscard]] static bool is_exhausted() { return false; }
  void split(const Interval& interval) { order.push_back(interval.low); }

  std::vector<double> order;
};

TEST(BestFirstSearch, TakesEqualBoundsInTheOrderTheyWereOffered) {
  Ties ties;
  ties.find();
  ASSERT_EQ(ties.order.size(), 20U);
  EXPECT_TRUE(std::is_sorted(ties.order.begin(), ties.order.end()));
}

TEST(SearchGoal, ProvesUpToTheToleranceAndClosesTheGapAboveIt) {
  const SearchGoal goal{0.1, 0.01, 0.5, 0};
  EXPECT_DOUBLE_EQ(goal.pruning_threshold_mm(0), 0.11);
  EXPECT_DOUBLE_EQ(goal.pruning_threshold_mm(0.1), 0.11);
  EXPECT_DOUBLE_EQ(goal.pruning_threshold_mm(0.2), 0.7);
}

}  // namespace
}  // namespace gouge::best_first_search_test

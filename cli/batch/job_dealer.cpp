#include "cli/batch/job_dealer.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

namespace gouge {

JobDealer::JobDealer(std::vector<std::size_t> group_ends, const std::vector<std::uint64_t>& work, std::size_t processes)
    : group_ends_(std::move(group_ends)), rests_(processes) {
  before_.reserve(work.size() + 1);
  std::partial_sum(work.begin(), work.end(), std::back_inserter(before_));
}

JobDealer::Block JobDealer::take(std::size_t process, std::size_t most) {
  if (rests_.empty()) return {};
  if (rests_.at(process).is_empty()) rests_[process] = begun_ < group_ends_.size() ? next_group() : half_of_largest();
  Rest& own = rests_[process];
  const Block block{own.next, std::min(most, own.end - own.next)};
  own.next += block.count;
  return block;
}

JobDealer::Rest JobDealer::next_group() {
  const std::size_t first = begun_ == 0 ? 0 : group_ends_[begun_ - 1];
  return {first, group_ends_[begun_++]};
}

// Takes the later half, because jobs of a group are sorted by size: the helping process receives the small jobs.
JobDealer::Rest JobDealer::half_of_largest() {
  Rest& largest = *std::ranges::max_element(rests_, {}, [&](const Rest& rest) { return work_of(rest); });
  if (largest.is_empty()) return {};
  const std::uint64_t half = before_[largest.next] + work_of(largest) / 2;
  const auto begin = before_.begin();
  const auto first = begin + static_cast<std::ptrdiff_t>(largest.next);
  const auto above = std::upper_bound(first, begin + static_cast<std::ptrdiff_t>(largest.end), half);
  const auto middle = static_cast<std::size_t>(above - begin) - 1;
  return {middle, std::exchange(largest.end, middle)};
}

}  // namespace gouge

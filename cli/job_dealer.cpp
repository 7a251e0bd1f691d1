#include "cli/job_dealer.h"

#include <algorithm>
#include <utility>

namespace gouge {

JobDealer::JobDealer(std::vector<std::size_t> group_ends, std::size_t processes)
    : group_ends_(std::move(group_ends)), rests_(processes) {}

JobDealer::Block JobDealer::take(std::size_t process, std::size_t most) {
  if (rests_.empty()) return {};
  if (rests_.at(process).count() == 0) rests_[process] = begun_ < group_ends_.size() ? next_group() : half_of_longest();
  Rest& own = rests_[process];
  const Block block{own.next, std::min(most, own.count())};
  own.next += block.count;
  return block;
}

JobDealer::Rest JobDealer::next_group() {
  const std::size_t first = begun_ == 0 ? 0 : group_ends_[begun_ - 1];
  return {first, group_ends_[begun_++]};
}

// The later half, as jobs of a group are sorted by size: who comes to help has the small ones to end with.
JobDealer::Rest JobDealer::half_of_longest() {
  Rest& longest = *std::ranges::max_element(rests_, {}, &Rest::count);
  const std::size_t middle = longest.next + longest.count() / 2;
  return {middle, std::exchange(longest.end, middle)};
}

}  // namespace gouge

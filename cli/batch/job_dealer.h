#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace gouge {

/// Distributes the positions 0, 1, 2, ... of a list of jobs to processes, each position once. The list consists of
/// groups of neighbours that read the same scene. A process continues in its group, then begins the first group that no
/// process has begun. If all are begun, it takes over the later half of the largest remaining work of another process.
/// So few processes read the same scene.
class JobDealer {
 public:
  /// The positions first, first + 1, ..., in total `count`; count 0: no position is left.
  struct Block {
    std::size_t first = 0, count = 0;
  };

  JobDealer() = default;
  /// `group_ends` has one past the last position of each group, ascending. `work` has the work of each position, > 0,
  /// in any unit.
  JobDealer(std::vector<std::size_t> group_ends, const std::vector<std::uint64_t>& work, std::size_t processes);

  /// Returns the next work of this process: at most `most` positions (> 0) of one group. Cost: constant; linear in the
  /// number of processes if work is taken over.
  [[nodiscard]] Block take(std::size_t process, std::size_t most);

 private:
  struct Rest {
    std::size_t next = 0, end = 0;
    [[nodiscard]] bool is_empty() const { return next == end; }
  };

  [[nodiscard]] Rest next_group();
  [[nodiscard]] Rest half_of_largest();
  [[nodiscard]] std::uint64_t work_of(const Rest& rest) const { return before_[rest.end] - before_[rest.next]; }

  std::vector<std::size_t> group_ends_;
  std::vector<std::uint64_t> before_ = {0};  // work of all positions before each one, and of all positions at the end
  std::size_t begun_ = 0;                    // number of groups that were begun
  std::vector<Rest> rests_;                  // for each process, the positions it has left
};

}  // namespace gouge

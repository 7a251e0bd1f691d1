#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace gouge {

/// Hands out the positions 0, 1, 2, ... of a list of jobs to processes, each position once. The list is in groups of
/// neighbours that read the same scene. A process goes on in its group, then begins the first group that no process has
/// begun. After these it takes over the later half of the rest with most work of another process. So few processes read
/// the same scene.
class JobDealer {
 public:
  /// Positions first, first + 1, ..., `count` of them; count 0: none is left.
  struct Block {
    std::size_t first = 0, count = 0;
  };

  JobDealer() = default;
  /// `group_ends`: one past the last position of each group, ascending. `work`: of each position, > 0, in any unit.
  JobDealer(std::vector<std::size_t> group_ends, const std::vector<std::uint64_t>& work, std::size_t processes);

  /// Returns the next work of this process, at most `most` positions (> 0) of one group. Cost: constant, and linear in
  /// the processes where something is taken over.
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
  std::vector<std::uint64_t> before_ = {0};  // work of all positions before each, and of all at the end
  std::size_t begun_ = 0;                    // groups
  std::vector<Rest> rests_;                  // of each process
};

}  // namespace gouge

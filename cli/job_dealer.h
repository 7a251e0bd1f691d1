#pragma once

#include <cstddef>
#include <vector>

namespace gouge {

/// Hands out the positions 0, 1, 2, ... of a list of jobs to processes, each position once. The list is in groups of
/// neighbours that read the same scene: a process goes on in its group, then begins the first group that nobody has
/// begun, then takes over the later half of the longest rest of another. So few processes read the same scene.
class JobDealer {
 public:
  /// Positions first, first + 1, ..., `count` of them; count 0: none is left.
  struct Block {
    std::size_t first = 0, count = 0;
  };

  JobDealer() = default;
  /// `group_ends`: one past the last position of each group, ascending.
  JobDealer(std::vector<std::size_t> group_ends, std::size_t processes);

  /// What comes next for this process, at most `most` positions (> 0) of one group. Cost: constant, and linear in the
  /// processes where something is taken over.
  [[nodiscard]] Block take(std::size_t process, std::size_t most);

 private:
  struct Rest {
    std::size_t next = 0, end = 0;
    [[nodiscard]] std::size_t count() const { return end - next; }
  };

  [[nodiscard]] Rest next_group();
  [[nodiscard]] Rest half_of_longest();

  std::vector<std::size_t> group_ends_;
  std::size_t begun_ = 0;    // groups
  std::vector<Rest> rests_;  // of each process
};

}  // namespace gouge

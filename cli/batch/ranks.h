#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "lib/base/result.h"

namespace gouge {

/// The processes that run one batch together: with mpirun several, else this one alone. Numbers, ranks and lists are
/// the same for all who call in the same order. Several threads may call take(); one thread calls all else.
class Ranks {
 public:
  Ranks() = default;
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;
  virtual ~Ranks() = default;

  [[nodiscard]] virtual int rank() const = 0;
  [[nodiscard]] virtual int count() const = 0;
  /// Begins list 0 or 1, whose groups end before these positions (JobDealer), the same for all processes. Only rank 0
  /// needs the `work` of each position.
  virtual void deal(int list, const std::vector<std::size_t>& group_ends, const std::vector<std::uint64_t>& work) = 0;
  /// Returns a position of the list that no process was given, by JobDealer's rule; none: all were given. A process may
  /// be given up to `most` of a group at once, which are its own from then on.
  [[nodiscard]] virtual std::optional<std::size_t> take(int list, std::size_t most) = 0;
  /// Gives all processes what rank 0 has.
  virtual void share(std::vector<std::size_t>& numbers) = 0;
  /// Returns the largest value of all processes, once all of them have called.
  [[nodiscard]] virtual int largest(int value) = 0;

  [[nodiscard]] bool is_first() const { return rank() == 0; }
};

/// Makes the ranks of mpirun, if it started this process; else this one alone. Errors: usage, where mpirun started
/// several processes of a program that was built without MPI, which would all do the same; module-missing.
[[nodiscard]] Result<std::unique_ptr<Ranks>> make_ranks();

}  // namespace gouge

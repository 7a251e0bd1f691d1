#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "lib/base/result.h"

namespace gouge {

/// The processes that run one batch together: several with mpirun, else this one alone. All processes must make the
/// same calls in the same order. Several threads may call take(); only one thread makes all other calls.
class Ranks {
 public:
  Ranks() = default;
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;
  virtual ~Ranks() = default;

  [[nodiscard]] virtual int rank() const = 0;
  [[nodiscard]] virtual int count() const = 0;
  /// Begins list 0 or 1, whose groups end before these positions (JobDealer). The positions are the same in all
  /// processes; only rank 0 needs the `work` of each position.
  virtual void deal(int list, const std::vector<std::size_t>& group_ends, const std::vector<std::uint64_t>& work) = 0;
  /// Returns a position of the list that no process has received, by the rule of JobDealer; nothing if none is left. A
  /// process may receive up to `most` positions of a group at once.
  [[nodiscard]] virtual std::optional<std::size_t> take(int list, std::size_t most) = 0;
  /// Copies the numbers of rank 0 to all processes.
  virtual void share(std::vector<std::size_t>& numbers) = 0;
  /// Returns the largest value among all processes. Waits until all of them have called.
  [[nodiscard]] virtual int largest(int value) = 0;

  [[nodiscard]] bool is_first() const { return rank() == 0; }
};

/// Returns how many processes mpirun started; 0: mpirun did not start this one.
[[nodiscard]] long long processes_of_mpirun();

/// Makes the ranks of mpirun, if it started this process; else those of this process alone. Errors: module-missing, and
/// usage if mpirun started several processes of a program without MPI, which would all do the same work.
[[nodiscard]] Result<std::unique_ptr<Ranks>> make_ranks();

}  // namespace gouge

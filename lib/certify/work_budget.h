#pragma once

#include <algorithm>
#include <cstdint>

namespace gouge {

/// How many bounds one step of a correction may compute. Bounds are counted, not time, so that a step ends alike on
/// every machine and at any number of threads. Of one thread.
class WorkBudget {
 public:
  explicit WorkBudget(std::uint64_t most) : most_(most) {}

  [[nodiscard]] std::uint64_t most() const { return most_; }
  [[nodiscard]] std::uint64_t left() const { return most_ - std::min(most_, spent_); }
  [[nodiscard]] bool is_spent() const { return spent_ >= most_; }
  void charge(std::uint64_t bounds) { spent_ += bounds; }

 private:
  std::uint64_t most_, spent_ = 0;
};

}  // namespace gouge

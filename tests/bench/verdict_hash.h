#pragma once

#include <bit>
#include <cstdint>

#include "lib/check/check_result.h"

namespace gouge::bench {

/// FNV-1a over everything the verdicts of a path state: equal bytes give equal hashes.
class VerdictHash {
 public:
  explicit VerdictHash(const CheckResult& result) {
    for (const MoveVerdict& v : result.verdicts) {
      add(static_cast<std::uint64_t>(v.state));
      add(v.depth_mm);
      add(v.depth_upper_mm);
      if (!v.witness) continue;
      add(v.witness->t);
      for (int k = 0; k < 3; ++k) add(v.witness->point[k]);
      for (int k = 0; k < 3; ++k) add(v.witness->normal[k]);
      add(static_cast<std::uint64_t>(v.witness->triangle));
    }
  }
  [[nodiscard]] std::uint64_t value() const { return value_; }

 private:
  void add(std::uint64_t word) {
    for (int k = 0; k < 8; ++k) {
      value_ = (value_ ^ (word & 255U)) * 1099511628211ULL;
      word >>= 8U;
    }
  }
  void add(double x) { add(std::bit_cast<std::uint64_t>(x)); }

  std::uint64_t value_ = 14695981039346656037ULL;
};

}  // namespace gouge::bench

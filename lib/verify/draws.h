#pragma once

#include <cstddef>
#include <cstdint>

namespace gouge {

/// A generator of pseudorandom numbers: S. Vigna's SplitMix64. It begins alike in every run.
class Draws {
 public:
  double share() { return static_cast<double>(next() >> 11) * 0x1p-53; }
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(share() * static_cast<double>(count)); }

 private:
  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15U);
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31U);
  }
  std::uint64_t state_ = 20260101;
};

}  // namespace gouge

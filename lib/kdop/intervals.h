#pragma once

#include <cstddef>

#include "lib/kdop/float4.h"

// A k-DOP as numbers in single precision, rounded outward. The order is: the lower ends of four axes, their upper ends,
// then the next four axes. So most overlap tests read one cache line. The stride is the number of axes rounded up to a
// multiple of four. Unused slots have the interval [-1, 1].

namespace gouge {

[[nodiscard]] constexpr std::size_t interval_stride(std::size_t axes) { return (axes + 3) / 4 * 4; }

/// Returns the slot of the lower end of axis `i`; the upper end is four slots behind it.
[[nodiscard]] constexpr std::size_t low_slot(std::size_t i) { return i / 4 * 8 + i % 4; }
[[nodiscard]] constexpr std::size_t high_slot(std::size_t i) { return low_slot(i) + 4; }

/// Returns whether the intervals overlap along every axis. Stops at the first block of four axes with disjoint
/// intervals.
[[nodiscard]] inline bool do_overlap(const float* a, const float* b, std::size_t stride) {
  for (std::size_t i = 0; i < 2 * stride; i += 8) {
    const Int4 apart = (load4(a + i) > load4(b + i + 4)) | (load4(b + i) > load4(a + i + 4));
    if (any4(apart)) return false;
  }
  return true;
}

/// Enlarges `a` so that it contains `b`.
inline void unite_intervals(float* a, const float* b, std::size_t stride) {
  for (std::size_t i = 0; i < 2 * stride; i += 8) {
    store4(a + i, min4(load4(a + i), load4(b + i)));
    store4(a + i + 4, max4(load4(a + i + 4), load4(b + i + 4)));
  }
}

}  // namespace gouge

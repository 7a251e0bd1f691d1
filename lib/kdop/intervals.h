#pragma once

#include <cstddef>

#include "lib/kdop/float4.h"

// A k-DOP as numbers: `stride` lower ends, then `stride` upper ends, single precision, widened outward when
// they are made. The stride is the number of axes rounded up to four; spare slots hold [-1, 1].

namespace gouge {

[[nodiscard]] constexpr std::size_t interval_stride(std::size_t axes) {
  return (axes + 3) / 4 * 4;
}

/// Whether the intervals meet along every axis. Ends when one block of four axes is apart.
[[nodiscard]] inline bool do_overlap(const float* a, const float* b, std::size_t stride) {
  for (std::size_t i = 0; i < stride; i += 4) {
    const Int4 apart = (load4(a + i) > load4(b + stride + i)) | (load4(b + i) > load4(a + stride + i));
    if (any4(apart)) return false;
  }
  return true;
}

/// Whether the projections `p` of a point lie in every interval.
[[nodiscard]] inline bool does_hold(const float* volume, const float* p, std::size_t stride) {
  for (std::size_t i = 0; i < stride; i += 4) {
    const Float4 at = load4(p + i);
    if (any4((load4(volume + i) > at) | (at > load4(volume + stride + i)))) return false;
  }
  return true;
}

/// Grows `a` to hold `b`.
inline void unite_intervals(float* a, const float* b, std::size_t stride) {
  for (std::size_t i = 0; i < stride; i += 4) {
    store4(a + i, min4(load4(a + i), load4(b + i)));
    store4(a + stride + i, max4(load4(a + stride + i), load4(b + stride + i)));
  }
}

}  // namespace gouge

#pragma once

// Included once for every instruction set, with GOUGE_KERNEL naming the namespace. Nothing here may come from
// another header as an inline function: it would be compiled for this instruction set and linked into the
// rest.
#include "lib/penetration/bound_block.h"

namespace gouge::GOUGE_KERNEL {
namespace {

using V = float __attribute__((vector_size(32)));

#define GOUGE_INLINE inline __attribute__((always_inline))

GOUGE_INLINE void load(const float* from, V& to) { __builtin_memcpy(&to, from, sizeof(V)); }
GOUGE_INLINE void max(V& a, const V& b) { a = a > b ? a : b; }
GOUGE_INLINE void sqrt(V& a) {
  for (int i = 0; i < 8; ++i) a[i] = __builtin_sqrtf(a[i]);
}

void least_mm(const BoundBlock& block, const float* point, float slack_mm, float* least) {
  const V none = V{};
  V box2 = none, away2 = none, over = none, away = none;
  for (int i = 0; i < 3; ++i) {
    V low, high, normal, centre;
    load(block.low[i], low);
    load(block.high[i], high);
    load(block.normal[i], normal);
    load(block.centre[i], centre);
    V out = low - point[i];
    max(out, point[i] - high);
    max(out, none);
    box2 += out * out;
    const V to = point[i] - centre;
    away2 += to * to;
    away += normal * to;
    over += normal * point[i];
  }
  V offset, half, radius;
  load(block.offset, offset);
  load(block.half, half);
  load(block.radius, radius);
  over -= offset;
  over = (over < none ? -over : over) - half;
  max(over, none);
  // Seen along the normal the facets lie within the radius of the centre. What lies across is taken a
  // millionth short: the difference of squares in single precision.
  V beyond = away2 * (1 - 1e-6F) - away * away;
  max(beyond, none);
  sqrt(beyond);
  beyond -= radius;
  max(beyond, none);
  V result = over * over + beyond * beyond;
  max(result, box2);
  sqrt(result);
  result -= slack_mm;
  max(result, none);
  __builtin_memcpy(least, &result, sizeof(V));
}

}  // namespace

extern const BoundKernel kKernel;
const BoundKernel kKernel = {GOUGE_KERNEL_NAME, least_mm};

}  // namespace gouge::GOUGE_KERNEL

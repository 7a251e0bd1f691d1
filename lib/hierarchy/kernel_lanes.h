#pragma once

// Sixteen lanes of single precision, for the bodies of kernels alone, under their rule: nothing here may come from
// another header as an inline function, as it would be compiled for this instruction set and linked into the rest.
#include "lib/hierarchy/blocks.h"

namespace gouge::GOUGE_KERNEL {
namespace {

using V = float __attribute__((vector_size(64)));
using M = int __attribute__((vector_size(64)));
using V8 = float __attribute__((vector_size(32)));
using M8 = int __attribute__((vector_size(32)));
using V4 = float __attribute__((vector_size(16)));
using M4 = int __attribute__((vector_size(16)));
constexpr M kLaneBit = {1 << 0, 1 << 1, 1 << 2,  1 << 3,  1 << 4,  1 << 5,  1 << 6,  1 << 7,
                        1 << 8, 1 << 9, 1 << 10, 1 << 11, 1 << 12, 1 << 13, 1 << 14, 1 << 15};

#define GOUGE_INLINE inline __attribute__((always_inline))

struct V3 {
  V x, y, z;
};

GOUGE_INLINE void load(const Lanes& from, V& to) { __builtin_memcpy(&to, &from, sizeof(V)); }
GOUGE_INLINE void load(const std::array<Lanes, 3>& from, V3& to) {
  load(from[0], to.x);
  load(from[1], to.y);
  load(from[2], to.z);
}
GOUGE_INLINE void store(const V& from, Lanes& to) { __builtin_memcpy(&to, &from, sizeof(V)); }
GOUGE_INLINE V broadcast(float x) { return x - V{}; }
#if defined(__AVX512F__)
GOUGE_INLINE M less(const V& a, const V& b) { return a < b; }
GOUGE_INLINE V select(const M& which, const V& a, const V& b) { return which ? a : b; }
#else
// Of vectors wider than the processor's g++ takes comparisons and choices apart into single numbers, so they are cut to
// its width here.
#if defined(__AVX2__)
using Part = V8;
using PartMask = M8;
#else
using Part = V4;
using PartMask = M4;
#endif
GOUGE_INLINE M less(const V& a, const V& b) {
  constexpr int kParts = sizeof(V) / sizeof(Part);
  Part left[kParts], right[kParts];
  PartMask outcome[kParts];
  __builtin_memcpy(left, &a, sizeof(V));
  __builtin_memcpy(right, &b, sizeof(V));
  for (int i = 0; i < kParts; ++i) outcome[i] = left[i] < right[i];
  M result;
  __builtin_memcpy(&result, outcome, sizeof(M));
  return result;
}
GOUGE_INLINE V select(const M& which, const V& a, const V& b) {
  M bits_a, bits_b;
  __builtin_memcpy(&bits_a, &a, sizeof(V));
  __builtin_memcpy(&bits_b, &b, sizeof(V));
  const M bits = (which & bits_a) | (~which & bits_b);
  V result;
  __builtin_memcpy(&result, &bits, sizeof(V));
  return result;
}
#endif
GOUGE_INLINE V max(const V& a, const V& b) { return select(less(b, a), a, b); }
GOUGE_INLINE V min(const V& a, const V& b) { return select(less(a, b), a, b); }
GOUGE_INLINE V abs(const V& a) { return select(less(a, V{}), -a, a); }
GOUGE_INLINE unsigned or_of(const M& a) {
  M8 half[2];
  M4 quarter[2];
  long pair[2];
  __builtin_memcpy(half, &a, sizeof(a));
  half[0] |= half[1];
  __builtin_memcpy(quarter, half, sizeof(quarter));
  quarter[0] |= quarter[1];
  __builtin_memcpy(pair, quarter, sizeof(pair));
  const auto both = static_cast<unsigned long>(pair[0] | pair[1]);
  return static_cast<unsigned>(both | (both >> 32));
}
GOUGE_INLINE bool any_of(const M& a) { return or_of(a) != 0; }
GOUGE_INLINE float least_of(const V& a) {
  V8 half[2];
  V4 quarter[2];
  __builtin_memcpy(half, &a, sizeof(a));
  half[0] = half[1] < half[0] ? half[1] : half[0];
  __builtin_memcpy(quarter, half, sizeof(quarter));
  quarter[0] = quarter[1] < quarter[0] ? quarter[1] : quarter[0];
  float least = quarter[0][0];
  for (int i = 1; i < 4; ++i) least = quarter[0][i] < least ? quarter[0][i] : least;
  return least;
}
GOUGE_INLINE V sqrt(const V& a) {
  V result;
  for (int i = 0; i < 16; ++i) result[i] = __builtin_sqrtf(a[i]);
  return result;
}
GOUGE_INLINE V dot(const V3& a, const V3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
GOUGE_INLINE V3 cross(const V3& a, const V3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
GOUGE_INLINE V3 minus(const V3& a, const V3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
GOUGE_INLINE V3 plus(const V3& a, const V3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
GOUGE_INLINE V3 times(const V3& a, const V& s) { return {a.x * s, a.y * s, a.z * s}; }
GOUGE_INLINE V3 broadcast(const std::array<float, 3>& a) { return {broadcast(a[0]), broadcast(a[1]), broadcast(a[2])}; }
GOUGE_INLINE V3 select(const M& which, const V3& a, const V3& b) {
  return {select(which, a.x, b.x), select(which, a.y, b.y), select(which, a.z, b.z)};
}

}  // namespace
}  // namespace gouge::GOUGE_KERNEL

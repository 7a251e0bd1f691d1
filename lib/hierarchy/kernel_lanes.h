#pragma once

// Sixteen lanes of single precision. Only the bodies of kernels include this file, and their rule holds here too. It
// must not use an inline function from another header: that function would be compiled for this instruction set and
// linked into the other code.
#include "lib/hierarchy/blocks.h"

namespace gouge::GOUGE_KERNEL {
namespace {

#define GOUGE_INLINE inline __attribute__((always_inline))

using V8 = float __attribute__((vector_size(32)));
using M8 = int __attribute__((vector_size(32)));
using V4 = float __attribute__((vector_size(16)));
using M4 = int __attribute__((vector_size(16)));

GOUGE_INLINE float min_of(const V4& a) {
  float least = a[0];
  for (int i = 1; i < 4; ++i) least = a[i] < least ? a[i] : least;
  return least;
}
#if defined(__AVX2__)
GOUGE_INLINE float min_of(const V8& a) {
  V4 half[2];
  __builtin_memcpy(half, &a, sizeof(a));
  return min_of(half[1] < half[0] ? half[1] : half[0]);
}
#endif

#if defined(__AVX512F__)

using V = float __attribute__((vector_size(64)));
using M = int __attribute__((vector_size(64)));

GOUGE_INLINE V broadcast(float x) { return x - V{}; }
GOUGE_INLINE V select(const M& which, const V& a, const V& b) { return which ? a : b; }
GOUGE_INLINE V max(const V& a, const V& b) { return select(b < a, a, b); }
GOUGE_INLINE V min(const V& a, const V& b) { return select(a < b, a, b); }
GOUGE_INLINE V sqrt(const V& a) {
  V result;
  for (int i = 0; i < 16; ++i) result[i] = __builtin_sqrtf(a[i]);
  return result;
}
GOUGE_INLINE unsigned bits_of(const M& which) {
  constexpr M kBit = {1 << 0, 1 << 1, 1 << 2,  1 << 3,  1 << 4,  1 << 5,  1 << 6,  1 << 7,
                      1 << 8, 1 << 9, 1 << 10, 1 << 11, 1 << 12, 1 << 13, 1 << 14, 1 << 15};
  const M bits = which & kBit;
  M8 half[2];
  M4 quarter[2];
  long pair[2];
  __builtin_memcpy(half, &bits, sizeof(bits));
  half[0] |= half[1];
  __builtin_memcpy(quarter, half, sizeof(quarter));
  quarter[0] |= quarter[1];
  __builtin_memcpy(pair, quarter, sizeof(pair));
  const auto both = static_cast<unsigned long>(pair[0] | pair[1]);
  return static_cast<unsigned>(both | (both >> 32));
}
GOUGE_INLINE float min_of(const V& a) {
  V8 half[2];
  __builtin_memcpy(half, &a, sizeof(a));
  return min_of(half[1] < half[0] ? half[1] : half[0]);
}

#else

// g++ splits comparisons and selections of vectors wider than the processor's into single numbers, which is ten times
// as slow. So here sixteen lanes consist of parts as wide as the processor's registers, and each operation is applied
// to each part.
template <class Part>
struct Halves {
  Part low, high;
};
#if defined(__AVX2__)
using V = Halves<V8>;
using M = Halves<M8>;
#else
using V = Halves<Halves<V4> >;
using M = Halves<Halves<M4> >;
#endif

#define GOUGE_OPERATOR(op)                                                     \
  template <class P>                                                           \
  GOUGE_INLINE auto operator op(const Halves<P>& a, const Halves<P>& b) {      \
    return Halves<decltype(a.low op b.low)>{a.low op b.low, a.high op b.high}; \
  }                                                                            \
  template <class P>                                                           \
  GOUGE_INLINE auto operator op(const Halves<P>& a, float b) {                 \
    return Halves<decltype(a.low op b)>{a.low op b, a.high op b};              \
  }                                                                            \
  template <class P>                                                           \
  GOUGE_INLINE auto operator op(float a, const Halves<P>& b) {                 \
    return Halves<decltype(a op b.low)>{a op b.low, a op b.high};              \
  }
GOUGE_OPERATOR(+)
GOUGE_OPERATOR(-)
GOUGE_OPERATOR(*)
GOUGE_OPERATOR(/)
GOUGE_OPERATOR(<)
GOUGE_OPERATOR(>)
GOUGE_OPERATOR(<=)
GOUGE_OPERATOR(>=)
#undef GOUGE_OPERATOR

template <class P>
GOUGE_INLINE Halves<P> operator&(const Halves<P>& a, const Halves<P>& b) {
  return {a.low & b.low, a.high & b.high};
}
template <class P>
GOUGE_INLINE Halves<P> operator|(const Halves<P>& a, const Halves<P>& b) {
  return {a.low | b.low, a.high | b.high};
}
template <class P>
GOUGE_INLINE Halves<P> operator~(const Halves<P>& a) {
  return {~a.low, ~a.high};
}
template <class P>
GOUGE_INLINE Halves<P> operator-(const Halves<P>& a) {
  return {-a.low, -a.high};
}
template <class P, class Q>
GOUGE_INLINE Halves<P>& operator+=(Halves<P>& a, const Q& b) {
  return a = a + b;
}
template <class P, class Q>
GOUGE_INLINE Halves<P>& operator-=(Halves<P>& a, const Q& b) {
  return a = a - b;
}

// Operations on one part. In each lane a mask has all bits set or none, as comparisons produce it.
#if defined(__AVX2__)
GOUGE_INLINE V8 select(const M8& which, const V8& a, const V8& b) {
  return __builtin_ia32_blendvps256(b, a, reinterpret_cast<V8>(which));
}
GOUGE_INLINE V8 max(const V8& a, const V8& b) { return __builtin_ia32_maxps256(a, b); }
GOUGE_INLINE V8 min(const V8& a, const V8& b) { return __builtin_ia32_minps256(a, b); }
GOUGE_INLINE V8 sqrt(const V8& a) { return __builtin_ia32_sqrtps256(a); }
GOUGE_INLINE unsigned bits_of(const M8& which) {
  return static_cast<unsigned>(__builtin_ia32_movmskps256(reinterpret_cast<V8>(which)));
}
#else
GOUGE_INLINE V4 select(const M4& which, const V4& a, const V4& b) {
  return reinterpret_cast<V4>((which & reinterpret_cast<M4>(a)) | (~which & reinterpret_cast<M4>(b)));
}
#if defined(__SSE2__)
GOUGE_INLINE V4 max(const V4& a, const V4& b) { return __builtin_ia32_maxps(a, b); }
GOUGE_INLINE V4 min(const V4& a, const V4& b) { return __builtin_ia32_minps(a, b); }
GOUGE_INLINE V4 sqrt(const V4& a) { return __builtin_ia32_sqrtps(a); }
GOUGE_INLINE unsigned bits_of(const M4& which) {
  return static_cast<unsigned>(__builtin_ia32_movmskps(reinterpret_cast<V4>(which)));
}
#else
GOUGE_INLINE V4 max(const V4& a, const V4& b) { return select(b < a, a, b); }
GOUGE_INLINE V4 min(const V4& a, const V4& b) { return select(a < b, a, b); }
GOUGE_INLINE V4 sqrt(const V4& a) {
  return V4{__builtin_sqrtf(a[0]), __builtin_sqrtf(a[1]), __builtin_sqrtf(a[2]), __builtin_sqrtf(a[3])};
}
GOUGE_INLINE unsigned bits_of(const M4& which) {
  const M4 bits = which & M4{1, 2, 4, 8};
  return static_cast<unsigned>(bits[0] | bits[1] | bits[2] | bits[3]);
}
#endif
#endif

template <class P, class Q>
GOUGE_INLINE Halves<Q> select(const Halves<P>& which, const Halves<Q>& a, const Halves<Q>& b) {
  return {select(which.low, a.low, b.low), select(which.high, a.high, b.high)};
}
template <class P>
GOUGE_INLINE Halves<P> max(const Halves<P>& a, const Halves<P>& b) {
  return {max(a.low, b.low), max(a.high, b.high)};
}
template <class P>
GOUGE_INLINE Halves<P> min(const Halves<P>& a, const Halves<P>& b) {
  return {min(a.low, b.low), min(a.high, b.high)};
}
template <class P>
GOUGE_INLINE Halves<P> sqrt(const Halves<P>& a) {
  return {sqrt(a.low), sqrt(a.high)};
}
/// Returns the mask as bits: bit i is lane i.
template <class P>
GOUGE_INLINE unsigned bits_of(const Halves<P>& which) {
  return bits_of(which.low) | bits_of(which.high) << (sizeof(P) / sizeof(float));
}
template <class P>
GOUGE_INLINE float min_of(const Halves<P>& a) {
  return min_of(min(a.high, a.low));
}
GOUGE_INLINE V broadcast(float x) { return x - V{}; }

#endif

struct V3 {
  V x, y, z;
};

#if defined(__AVX512F__)
GOUGE_INLINE void load(const float* from, V& to) { __builtin_memcpy(&to, from, sizeof(V)); }
GOUGE_INLINE void store(const V& from, float* to) { __builtin_memcpy(to, &from, sizeof(V)); }
#else
// Copies part by part: a value that is read in other pieces than it was written has to wait for the memory.
template <class P>
GOUGE_INLINE void load(const float* from, P& to) {
  __builtin_memcpy(&to, from, sizeof(P));
}
template <class P>
GOUGE_INLINE void load(const float* from, Halves<P>& to) {
  load(from, to.low);
  load(from + sizeof(P) / sizeof(float), to.high);
}
template <class P>
GOUGE_INLINE void store(const P& from, float* to) {
  __builtin_memcpy(to, &from, sizeof(P));
}
template <class P>
GOUGE_INLINE void store(const Halves<P>& from, float* to) {
  store(from.low, to);
  store(from.high, to + sizeof(P) / sizeof(float));
}
#endif
GOUGE_INLINE void load(const Lanes& from, V& to) { load(reinterpret_cast<const float*>(&from), to); }
GOUGE_INLINE void store(const V& from, Lanes& to) { store(from, reinterpret_cast<float*>(&to)); }
GOUGE_INLINE void load(const std::array<Lanes, 3>& from, V3& to) {
  load(from[0], to.x);
  load(from[1], to.y);
  load(from[2], to.z);
}
GOUGE_INLINE V abs(const V& a) { return select(a < 0, -a, a); }
GOUGE_INLINE bool any_of(const M& a) { return bits_of(a) != 0; }
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

#pragma once

#include <cstring>

// Four floats side by side, in the vector form of both g++ and clang. It requires no instruction set beyond the
// processor's base.

namespace gouge {

using Float4 = float __attribute__((vector_size(16)));
using Int4 = int __attribute__((vector_size(16)));

[[nodiscard]] inline Float4 load4(const float* from) {
  Float4 value;
  std::memcpy(&value, from, sizeof value);
  return value;
}
inline void store4(float* to, Float4 value) { std::memcpy(to, &value, sizeof value); }
[[nodiscard]] inline Float4 all4(float x) { return Float4{x, x, x, x}; }
[[nodiscard]] inline Float4 min4(Float4 a, Float4 b) { return a < b ? a : b; }
[[nodiscard]] inline Float4 max4(Float4 a, Float4 b) { return a > b ? a : b; }
[[nodiscard]] inline bool any4(Int4 mask) {
  long long halves[2];
  std::memcpy(halves, &mask, sizeof halves);
  return (halves[0] | halves[1]) != 0;
}
[[nodiscard]] inline float lowest4(Float4 v) {
  const float a = v[0] < v[1] ? v[0] : v[1], b = v[2] < v[3] ? v[2] : v[3];
  return a < b ? a : b;
}
[[nodiscard]] inline float highest4(Float4 v) {
  const float a = v[0] > v[1] ? v[0] : v[1], b = v[2] > v[3] ? v[2] : v[3];
  return a > b ? a : b;
}

}  // namespace gouge

#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "lib/geom/vec.h"

namespace gouge::test {

/// Random numbers, points and directions for tests. A seed gives the same values on every machine and with every
/// standard library, although the distributions of these libraries differ. The generator is SplitMix64 by Steele, Lea
/// and Flood.
class Scatter {
 public:
  explicit Scatter(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15ull);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
    return z ^ (z >> 31);
  }
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(next() % n); }
  double in(double low, double high) { return low + (high - low) * (static_cast<double>(next() >> 11) * 0x1.0p-53); }
  bool is(double share) { return in(0, 1) < share; }

  /// Returns a point in the cube about the origin whose half side is `size`.
  Vec3 point(double size) {
    const double x = in(-size, size), y = in(-size, size), z = in(-size, size);
    return {x, y, z};
  }
  /// Returns a unit vector; all directions are equally likely.
  Vec3 direction() {
    for (;;) {
      const Vec3 v = point(1);
      if (v.squaredNorm() < 1 && v.squaredNorm() > 1e-6) return v.normalized();
    }
  }
  /// Returns a unit vector that is upright except for a deviation of at most `lean` in x and y.
  Vec3 axis(double lean) {
    const double x = in(-lean, lean), y = in(-lean, lean);
    return Vec3(x, y, 1).normalized();
  }

  template <class T>
  void shuffle(std::vector<T>& items) {
    for (std::size_t n = items.size(); n > 1; --n) std::swap(items[n - 1], items[below(n)]);
  }

 private:
  std::uint64_t state_;
};

}  // namespace gouge::test

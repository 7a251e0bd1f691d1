#pragma once

#include <random>

#include "lib/geom/vec.h"

namespace gouge::test {

/// Random numbers and places for tests that hold a bound against sampling; the same for a seed on every run.
class Scatter {
 public:
  explicit Scatter(unsigned seed) : random_(seed) {}
  double in(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  Vec3 axis(double lean) { return Vec3(in(-lean, lean), in(-lean, lean), 1).normalized(); }
  Vec3 point(double size) { return {in(-size, size), in(-size, size), in(-size, size)}; }

 private:
  std::mt19937_64 random_;
};

}  // namespace gouge::test

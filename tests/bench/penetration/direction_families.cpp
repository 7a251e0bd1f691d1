#include "tests/bench/penetration/direction_families.h"

#include <cmath>

#include "tests/bench/penetration/coulomb.h"

namespace gouge {
namespace {

constexpr std::size_t kLargestCoulomb = 128;

void add_corners(DirectionSet& set) {
  for (const Vec3& axis : {Vec3(1, 1, 1), Vec3(1, 1, -1), Vec3(1, -1, 1), Vec3(-1, 1, 1)})
    set.axes.push_back(axis.normalized());
}

/// (0, +-short, long) and its cyclic shifts: one of each opposite pair.
void add_golden(DirectionSet& set, double short_side, double long_side) {
  for (const double s : {short_side, -short_side}) {
    set.axes.push_back(Vec3(0, s, long_side).normalized());
    set.axes.push_back(Vec3(s, long_side, 0).normalized());
    set.axes.push_back(Vec3(long_side, 0, s).normalized());
  }
}

std::optional<DirectionSet> platonic_directions(std::size_t k) {
  const double golden = (1 + std::sqrt(5.0)) / 2;
  DirectionSet set;
  if (k == 8) {
    add_corners(set);
  } else if (k == 12) {
    add_golden(set, 1, golden);
  } else if (k == 20) {
    add_corners(set);
    add_golden(set, golden, 1 / golden);
  } else {
    return std::nullopt;
  }
  return set;
}

}  // namespace

std::optional<DirectionSet> make_directions(DirectionFamily family, std::size_t k) {
  if (family == DirectionFamily::platonic) return platonic_directions(k);
  if (k < 6 || k > kLargestCoulomb || k % 2 != 0) return std::nullopt;
  return DirectionSet{spread_axes(k / 2)};
}

}  // namespace gouge

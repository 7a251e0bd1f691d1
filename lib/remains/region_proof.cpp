#include "lib/remains/region_proof.h"

#include <algorithm>
#include <array>

namespace gouge {

namespace {

// Material between cuts counts as a sliver if no point of it is found deeper than this, as a share of the inset.
constexpr double kSeam = 0.1;

/// Halves a box at the middle of its longest side, or a tetrahedron at the middle of its longest edge.
std::array<HullRegion, 2> halves(const HullRegion& region) {
  if (region.count == HullRegion::kMaxPoints) {
    const Vec3 low = region.low(), high = region.high();
    Eigen::Index axis = 0;
    (high - low).maxCoeff(&axis);
    Vec3 below = high, above = low;
    below[axis] = above[axis] = 0.5 * (low[axis] + high[axis]);
    return {HullRegion::box(low, below), HullRegion::box(above, high)};
  }
  std::array<Vec3, 4> first{}, second{};
  std::copy_n(region.corners.begin(), 4, first.begin());
  second = first;
  std::size_t a = 0, b = 1;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j)
      if ((first[i] - first[j]).squaredNorm() > (first[a] - first[b]).squaredNorm()) a = i, b = j;
  const Vec3 middle = 0.5 * (first[a] + first[b]);
  first[a] = middle;
  second[b] = middle;
  return {HullRegion::tetrahedron(first), HullRegion::tetrahedron(second)};
}

}  // namespace

bool RegionProof::holds(const HullRegion& region, int halvings) {
  if (side_.proves(region, hint_)) return true;
  const bool is_widened = kind_ == Kind::widened;
  const Vec3 middle = region.middle();
  const double depth = side_.at(middle, region.reach_mm(middle)).mm + inset_mm_;
  if (depth < (is_widened ? -kSeam * inset_mm_ : 0)) return false;
  if (is_widened && side_.proves_widened(region, hint_)) return true;
  if (halvings == 0) return false;
  return std::ranges::all_of(halves(region), [&](const HullRegion& half) { return holds(half, halvings - 1); });
}

}  // namespace gouge

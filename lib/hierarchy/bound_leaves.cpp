#include "lib/hierarchy/bound_leaves.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lib/base/instruction_sets.h"
#include "lib/base/tolerance.h"

namespace gouge::detail {
namespace {

// Loops over sixteen numbers, which the compiler adapts to the width of the processor. It would split vectors of
// sixteen on a narrower processor into single numbers wherever they are compared.

[[gnu::always_inline]] inline void keep_largest(float value, float& largest) {
  largest = value > largest ? value : largest;
}

/// A vector of three numbers in single precision.
using Single3 = std::array<float, 3>;

Single3 single(const Vec3& v) {
  return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

GOUGE_WIDE void find_extent(const TriangleBlock* leaf, const TriangleBlock* end, const std::array<Single3, 3>& axes,
                            LeafExtent& extent) {
  for (std::size_t k = 0; k < 3; ++k) {
    const auto [ax, ay, az] = axes[k];
    Lanes high, low;
    high.fill(-std::numeric_limits<float>::max());
    low = high;
    for (const TriangleBlock* at = leaf; at != end; ++at) {
      for (std::size_t c = 0; c < 3; ++c) {
        const auto& [x, y, z] = at->corner[c];
        for (std::size_t i = 0; i < kBlockLanes; ++i) {
          const float along = ax * x[i] + ay * y[i] + az * z[i];
          keep_largest(along, high[i]);
          keep_largest(-along, low[i]);
        }
      }
    }
    extent.high[k] = high;
    extent.low[k] = low;
  }
}

/// Largest height over the plane, squared distance from the axis and squared distance, each measured from one center.
struct Reach {
  Lanes height, disc2, radius2;
};

GOUGE_WIDE void find_reach(const TriangleBlock* leaf, const TriangleBlock* end, const Single3& center,
                           const Single3& normal, Reach& reach) {
  const auto [cx, cy, cz] = center;
  const auto [nx, ny, nz] = normal;
  Lanes height{}, disc2{}, radius2{};
  for (; leaf != end; ++leaf) {
    for (std::size_t c = 0; c < 3; ++c) {
      for (std::size_t i = 0; i < kBlockLanes; ++i) {
        const float x = leaf->corner[c][0][i] - cx, y = leaf->corner[c][1][i] - cy, z = leaf->corner[c][2][i] - cz;
        const float h = nx * x + ny * y + nz * z;
        const float u = x - h * nx, v = y - h * ny, w = z - h * nz;
        keep_largest(h, height[i]);
        keep_largest(-h, height[i]);
        keep_largest(u * u + v * v + w * w, disc2[i]);
        keep_largest(x * x + y * y + z * z, radius2[i]);
      }
    }
  }
  reach = {height, disc2, radius2};
}

GOUGE_WIDE void find_areas(const TriangleBlock& leaf, std::array<Lanes, 3>& areas) {
  const auto& [a, b, c] = leaf.corner;
  for (std::size_t i = 0; i < kBlockLanes; ++i) {
    const float bx = b[0][i] - a[0][i], by = b[1][i] - a[1][i], bz = b[2][i] - a[2][i];
    const float cx = c[0][i] - a[0][i], cy = c[1][i] - a[1][i], cz = c[2][i] - a[2][i];
    areas[0][i] = by * cz - bz * cy;
    areas[1][i] = bz * cx - bx * cz;
    areas[2][i] = bx * cy - by * cx;
  }
}

double largest(const Lanes& lanes) { return static_cast<double>(*std::max_element(lanes.begin(), lanes.end())); }

float rounded_up(double length) {
  return std::nextafter(static_cast<float>(length), std::numeric_limits<float>::max());
}

}  // namespace

std::array<float, 3> area_sum(const TriangleBlock& leaf) {
  std::array<Lanes, 3> areas;
  find_areas(leaf, areas);
  std::array<float, 3> sum{};
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t i = 0; i < leaf.count; ++i) sum[k] += areas[k][i];
  }
  return sum;
}

void bound_leaves(std::span<const TriangleBlock> leaves, const Vec3& direction, double rounding_mm, NodeBlock& node,
                  std::size_t lane) {
  const TriangleBlock* first = leaves.data();
  const TriangleBlock* end = first + leaves.size();
  const double length = direction.norm();
  const Vec3 normal = length > 0 ? Vec3(direction / length) : Vec3::UnitZ();
  const Vec3 u = normal.unitOrthogonal();
  const Vec3 v = normal.cross(u);
  LeafExtent extent;
  find_extent(first, end, {single(u), single(v), single(normal)}, extent);
  const auto middle = [&](std::size_t k) { return 0.5 * (largest(extent.high[k]) - largest(extent.low[k])); };
  const Single3 center = single(middle(0) * u + middle(1) * v + middle(2) * normal);
  const Single3 stored_normal = single(normal);
  Reach reach;
  find_reach(first, end, center, stored_normal, reach);
  for (std::size_t k = 0; k < 3; ++k) {
    node.center[k][lane] = center[k];
    node.normal[k][lane] = stored_normal[k];
  }
  // The error of differences, products and sums in single precision is at most 7 units of 6e-8 of the distance from the
  // center. The length of the stored normal differs from 1 by 1e-7.
  const double radius = std::sqrt(largest(reach.radius2));
  const double more = rounding_mm + 8 * Tolerance::kSingleRounding * radius + Tolerance::kRounding_mm;
  node.half_thickness_mm[lane] = rounded_up(largest(reach.height) + more);
  node.disc_radius_mm[lane] = rounded_up(std::sqrt(largest(reach.disc2)) + more);
  node.radius_mm[lane] = rounded_up(radius + more);
}

LeafExtent extent_of(const TriangleBlock& leaf, const std::array<Vec3, 3>& directions) {
  LeafExtent extent;
  find_extent(&leaf, &leaf + 1, {single(directions[0]), single(directions[1]), single(directions[2])}, extent);
  return extent;
}

}  // namespace gouge::detail

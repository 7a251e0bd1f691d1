#include "lib/hierarchy/bound_leaves.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lib/base/instruction_sets.h"

namespace gouge::detail {
namespace {

// Twice what single precision does to a number, relative to it.
constexpr double kLeafSingle = 1.2e-7;

using V = float __attribute__((vector_size(64)));

struct V3 {
  V x, y, z;
};

[[gnu::always_inline]] inline void load_lanes(const Lanes& from, V& to) {
  __builtin_memcpy(&to, from.data(), sizeof to);
}

[[gnu::always_inline]] inline void store_lanes(const V& from, Lanes& to) {
  __builtin_memcpy(to.data(), &from, sizeof from);
}

[[gnu::always_inline]] inline void load_lanes(const std::array<Lanes, 3>& from, V3& to) {
  load_lanes(from[0], to.x);
  load_lanes(from[1], to.y);
  load_lanes(from[2], to.z);
}

[[gnu::always_inline]] inline void keep_largest(const V& value, V& largest) {
  largest = value > largest ? value : largest;
}

/// A vector of three numbers of single precision.
using Single3 = std::array<float, 3>;

Single3 single(const Vec3& v) {
  return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

GOUGE_WIDE void find_extent(const TriangleBlock* leaf, const TriangleBlock* end, const std::array<Single3, 3>& axes,
                            LeafExtent& extent) {
  V high[3], low[3];
  for (std::size_t k = 0; k < 3; ++k) high[k] = low[k] = V{} - std::numeric_limits<float>::max();
  for (; leaf != end; ++leaf) {
    for (std::size_t c = 0; c < 3; ++c) {
      V3 p;
      load_lanes(leaf->corner[c], p);
      for (std::size_t k = 0; k < 3; ++k) {
        const V along = axes[k][0] * p.x + axes[k][1] * p.y + axes[k][2] * p.z;
        keep_largest(along, high[k]);
        keep_largest(-along, low[k]);
      }
    }
  }
  for (std::size_t k = 0; k < 3; ++k) {
    store_lanes(high[k], extent.high[k]);
    store_lanes(low[k], extent.low[k]);
  }
}

/// Largest height over the plane, squared distance from the axis and squared distance, all from one center.
struct Reach {
  Lanes height, disc2, radius2;
};

GOUGE_WIDE void find_reach(const TriangleBlock* leaf, const TriangleBlock* end, const Single3& center,
                           const Single3& normal, Reach& reach) {
  V height{}, disc2{}, radius2{};
  for (; leaf != end; ++leaf) {
    for (std::size_t c = 0; c < 3; ++c) {
      V3 p;
      load_lanes(leaf->corner[c], p);
      const V x = p.x - center[0], y = p.y - center[1], z = p.z - center[2];
      const V h = normal[0] * x + normal[1] * y + normal[2] * z;
      const V u = x - h * normal[0], v = y - h * normal[1], w = z - h * normal[2];
      keep_largest(h, height);
      keep_largest(-h, height);
      keep_largest(u * u + v * v + w * w, disc2);
      keep_largest(x * x + y * y + z * z, radius2);
    }
  }
  store_lanes(height, reach.height);
  store_lanes(disc2, reach.disc2);
  store_lanes(radius2, reach.radius2);
}

GOUGE_WIDE void find_areas(const TriangleBlock& leaf, std::array<Lanes, 3>& areas) {
  V3 a, b, c;
  load_lanes(leaf.corner[0], a);
  load_lanes(leaf.corner[1], b);
  load_lanes(leaf.corner[2], c);
  const V bx = b.x - a.x, by = b.y - a.y, bz = b.z - a.z, cx = c.x - a.x, cy = c.y - a.y, cz = c.z - a.z;
  store_lanes(by * cz - bz * cy, areas[0]);
  store_lanes(bz * cx - bx * cz, areas[1]);
  store_lanes(bx * cy - by * cx, areas[2]);
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
  // Differences, products and sums in single precision are off by no more than 7 units of 6e-8 of the
  // distance from the center, and the stored normal is longer or shorter than 1 by 1e-7.
  const double radius = std::sqrt(largest(reach.radius2));
  const double more = rounding_mm + 8 * kLeafSingle * radius + 1e-9;
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

#include "postproc/viewer/surface_values.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "lib/base/tolerance.h"

namespace gouge {
namespace {

// Spreads the lowest 21 bits of a number to every third bit.
std::uint64_t spread_bits(std::uint64_t x) {
  x &= 0x1FFFFFU;
  x = (x | x << 32) & 0x1F00000000FFFFU;
  x = (x | x << 16) & 0x1F0000FF0000FFU;
  x = (x | x << 8) & 0x100F00F00F00F00FU;
  x = (x | x << 4) & 0x10C30C30C30C30C3U;
  return (x | x << 2) & 0x1249249249249249U;
}

// Returns the order of the points along Morton's curve through their box. Fields are fast if neighbours in the list are
// neighbours in space.
std::vector<std::uint32_t> in_space(const std::vector<SurfacePoint>& points) {
  Box3 box;
  for (const SurfacePoint& p : points) box.extend(p.at);
  const double side = std::max(box.sizes().maxCoeff(), Tolerance::kSamePoint_mm);
  std::vector<std::pair<std::uint64_t, std::uint32_t>> keys(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::uint64_t key = 0;
    for (int axis = 0; axis < 3; ++axis)
      key |= spread_bits(static_cast<std::uint64_t>((points[i].at[axis] - box.min()[axis]) / side * 0x1FFFFF)) << axis;
    keys[i] = {key, static_cast<std::uint32_t>(i)};
  }
  std::sort(keys.begin(), keys.end());
  std::vector<std::uint32_t> order(points.size());
  std::transform(keys.begin(), keys.end(), order.begin(), [](const auto& key) { return key.second; });
  return order;
}

}  // namespace

// Drops points that are far from all gouges. Most points are, and this test is cheaper than a ray.
void SurfaceValues::drop_untouched(const std::vector<SurfacePoint>& points, std::vector<std::uint32_t>& order) const {
  std::vector<Vec3> places;
  places.reserve(order.size());
  for (const std::uint32_t i : order) places.push_back(points[i].at);
  const std::vector<std::uint8_t> may_be = path_.overcuts.may_be_deep(places, 0);
  std::size_t kept = 0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (may_be[k] != 0) order[kept++] = order[k];
  }
  order.resize(kept);
}

std::vector<float> SurfaceValues::at(const std::vector<SurfacePoint>& points, SurfaceQuantity quantity) const {
  std::vector<float> values(points.size(), 0.0F);
  if (is_empty() || points.empty() || (quantity == SurfaceQuantity::overcut && !is_overcut())) return values;
  std::vector<std::uint32_t> order = in_space(points);
  std::vector<float> sorted;
  if (is_overcut() && quantity != SurfaceQuantity::depth) {
    drop_untouched(points, order);
    std::vector<OvercutField::Ray> rays;
    rays.reserve(points.size());
    for (const std::uint32_t i : order) rays.push_back({points[i].at, -points[i].normal, points[i].mesh});
    sorted = quantity == SurfaceQuantity::overcut ? path_.overcuts.overcut_at(rays) : path_.overcuts.at(rays);
  } else {
    const std::vector<Against> obstacles = obstacle_of_meshes(*path_.input.scene);
    const std::vector<double> clearances_mm = clearance_of_meshes(*path_.input.scene);
    std::vector<FieldPoint> asked;
    asked.reserve(points.size());
    for (const std::uint32_t i : order)
      asked.push_back({points[i].at, obstacles[points[i].mesh], clearances_mm[points[i].mesh]});
    sorted = path_.depths.depth_at(asked);
  }
  for (std::size_t k = 0; k < order.size(); ++k) values[order[k]] = sorted[k];
  return values;
}

}  // namespace gouge

#include "lib/verify/triangle_order.h"

#include <algorithm>
#include <numeric>

#include "lib/verify/bounds.h"

namespace gouge {
namespace {

constexpr std::uint32_t kMaxWithNormal = 512;
constexpr double kEven = 0.95;  // cosine of the largest angle between normals and their mean

}  // namespace

TriangleOrder::TriangleOrder(std::span<const IndexedMesh> meshes) : meshes_(meshes) {
  std::vector<Named> names;
  for (std::uint32_t m = 0; m < meshes.size(); ++m)
    for (std::uint32_t t = 0; t < meshes[m].triangles.size(); ++t) names.push_back({m, t});
  order_ = names;
  std::vector<Vec3> centers(names.size());
  for (std::uint32_t i = 0; i < names.size(); ++i) {
    const std::array<Vec3, 3> c = corners(i);
    centers[i] = c[0] + c[1] + c[2];
  }
  std::vector<std::uint32_t> order(names.size());
  std::iota(order.begin(), order.end(), 0U);
  sort(root(), centers, order);
  for (std::size_t i = 0; i < order.size(); ++i) order_[i] = names[order[i]];
  extents_.resize(order_.size());
  const RoundsUpward upward;
  bound(root());
}

std::array<Vec3, 3> TriangleOrder::corners(std::uint32_t place) const {
  const IndexedMesh& mesh = meshes_[order_[place].mesh];
  const std::size_t t = order_[place].triangle;
  return {mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)};
}

// Sorts a node: the half with the smaller centres is first, along the direction of their largest extent.
void TriangleOrder::sort(const Node& node, std::vector<Vec3>& centers, std::vector<std::uint32_t>& order) {
  if (node.size() < 2) return;
  Box3 box;
  for (std::uint32_t i = node.first; i < node.last; ++i) box.extend(centers[order[i]]);
  Eigen::Index along = 0;
  box.sizes().maxCoeff(&along);
  std::nth_element(order.begin() + node.first, order.begin() + node.middle(), order.begin() + node.last,
                   [&](std::uint32_t a, std::uint32_t b) {
                     const double at_a = centers[a][along], at_b = centers[b][along];
                     return at_a < at_b || (!(at_b < at_a) && a < b);
                   });
  sort({node.first, node.middle()}, centers, order);
  sort({node.middle(), node.last}, centers, order);
}

/// Returns the box of a node, and sets the extents of the node and of all nodes below it.
Box3 TriangleOrder::bound(const Node& node) {
  Box3 box;
  if (node.size() == 0) return box;
  if (node.size() == 1) {
    for (const Vec3& p : corners(node.first)) box.extend(p);
    return box;
  }
  box = bound({node.first, node.middle()}).merged(bound({node.middle(), node.last}));
  Extent& extent = extents_[node.middle()];
  extent.center = 0.5 * (box.min() + box.max());
  for (int k = 0; k < 3; ++k) {
    const Bounds c(extent.center[k]);
    extent.half[k] = std::max((Bounds(box.max()[k]) - c).sup(), (c - Bounds(box.min()[k])).sup());
  }
  if (node.size() > kMaxWithNormal) return box;
  Vec3 sum = Vec3::Zero();
  for (std::uint32_t i = node.first; i < node.last; ++i) {
    const std::array<Vec3, 3> c = corners(i);
    sum -= (c[1] - c[0]).cross(c[2] - c[0]);
  }
  if (!(sum.norm() > 0)) return box;
  const Vec3 into = sum.normalized();
  double least = 1e300;
  for (std::uint32_t i = node.first; i < node.last; ++i) {
    const std::array<Vec3, 3> c = corners(i);
    const Vec3 own = -(c[1] - c[0]).cross(c[2] - c[0]);
    if (!(own.dot(into) >= kEven * own.norm())) return box;
    for (const Vec3& p : c) least = std::min(least, dot(Bounds3(into), Bounds3(p)).inf());
  }
  extent.into = into;
  extent.least = least;
  return box;
}

}  // namespace gouge

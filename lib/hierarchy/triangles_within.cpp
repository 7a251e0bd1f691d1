#include "lib/hierarchy/triangles_within.h"

#include <algorithm>

#include "lib/hierarchy/lane_bound.h"

namespace gouge {
namespace {

constexpr double kRounding_mm = 1e-9;  // of a LaneBound and a few additions

bool may_reach(const LaneBound& bound, std::span<const HalfSpace> space) {
  return std::all_of(space.begin(), space.end(), [&](const HalfSpace& half) {
    return half.direction.dot(bound.center) + bound.extent_mm(half.direction) + kRounding_mm >= half.least_mm;
  });
}

/// Calls `visit(leaf)` for the leaves whose bounds reach into each half-space, until it returns true. Whether it did.
template <typename Visit>
bool visit_leaves(const BlockTree& tree, std::span<const HalfSpace> space, const Visit& visit) {
  std::vector<std::uint32_t> open(tree.nodes.empty() ? 0 : 1, 0);
  while (!open.empty()) {
    const NodeBlock& node = tree.nodes[open.back()];
    open.pop_back();
    for (std::size_t lane = 0; lane < node.count; ++lane) {
      if (!may_reach(LaneBound(tree, node, lane), space)) continue;
      if (!node.has_leaves) {
        open.push_back(node.child[lane]);
      } else if (visit(tree.leaves[node.child[lane]])) {
        return true;
      }
    }
  }
  return false;
}

/// A convex polygon that is cut: a triangle by up to twelve planes.
struct Polygon {
  std::array<Vec3, 16> corners;
  std::size_t count = 0;

  void cut(const HalfSpace& half) {
    Polygon kept;
    const double least_mm = half.least_mm - kRounding_mm;
    for (std::size_t i = 0; i < count; ++i) {
      const Vec3 &a = corners[i], &b = corners[i + 1 < count ? i + 1 : 0];
      const double in_a = half.direction.dot(a) - least_mm, in_b = half.direction.dot(b) - least_mm;
      if (in_a >= 0) kept.corners[kept.count++] = a;
      if ((in_a >= 0) != (in_b >= 0)) kept.corners[kept.count++] = a + in_a / (in_a - in_b) * (b - a);
    }
    *this = kept;
  }
};

bool reaches_into(const std::array<Vec3, 3>& triangle, std::span<const HalfSpace> space) {
  Polygon left;
  std::copy(triangle.begin(), triangle.end(), left.corners.begin());
  left.count = 3;
  return std::all_of(space.begin(), space.end(), [&](const HalfSpace& half) {
    left.cut(half);
    return left.count > 0;
  });
}

}  // namespace

std::vector<std::uint32_t> triangles_within(const BlockTree& tree, std::span<const HalfSpace> space) {
  std::vector<std::uint32_t> found;
  visit_leaves(tree, space, [&](const TriangleBlock& leaf) {
    found.insert(found.end(), leaf.triangle.begin(), leaf.triangle.begin() + leaf.count);
    return false;
  });
  std::sort(found.begin(), found.end());
  return found;
}

bool is_entered(const BlockTree& tree, std::span<const HalfSpace> space) {
  return visit_leaves(tree, space, [&](const TriangleBlock& leaf) {
    for (std::size_t k = 0; k < leaf.count; ++k) {
      if (reaches_into(tree.corners(leaf.triangle[k]), space)) return true;
    }
    return false;
  });
}

}  // namespace gouge

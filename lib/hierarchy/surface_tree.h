#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "lib/geom/vec.h"
#include "lib/mesh/indexed_mesh.h"

// A binary tree over the triangles of one or more meshes. Every node bounds its triangles twice: by a ball,
// and by a disc whose direction is near the surface's own normal, thin where the surface is nearly flat. The
// disc is what a first-order bound needs: a surface lying along the tool costs one node, not its area.
// Source: bounding volume hierarchies in thesis 2.3 and 4.6, the oriented disc in place of the k-DOP slab
// pairs (docs/decisions/0006_oriented_discs.md).

namespace gouge {

struct SurfaceNode {
  Vec3 center;                   ///< mm, part coordinates
  Vec3 normal;                   ///< unit
  double radius_mm = 0;          ///< |x - center| <= radius for every x below
  double half_thickness_mm = 0;  ///< |normal . (x - center)| <= half_thickness
  double disc_radius_mm = 0;     ///< distance of x from the line through center along normal
  std::uint32_t first = 0;  ///< leaf: first triangle; inner: index of the first child, the second follows it
  std::uint32_t count = 0;  ///< leaf: how many triangles; inner: 0
};

struct SurfaceTriangle {
  std::array<Vec3, 3> corners;  ///< mm, part coordinates
  std::uint32_t mesh = 0;       ///< index into the meshes the tree was built from
  std::uint32_t file_triangle = 0;
};

struct SurfaceTree {
  std::vector<SurfaceNode> nodes;          ///< nodes[0] is the root; empty when there is no triangle
  std::vector<SurfaceTriangle> triangles;  ///< in leaf order
};

/// Builds the tree. Ensures verify_tree(result).empty(). Deterministic: ties are broken by triangle order.
/// Cost O(n log n) time; about 220 bytes a triangle.
[[nodiscard]] SurfaceTree build_surface_tree(const std::vector<IndexedMesh>& meshes);

/// Broken invariants, one sentence each: every triangle in exactly one leaf, every bound holds.
[[nodiscard]] std::vector<std::string> verify_tree(const SurfaceTree& tree);

}  // namespace gouge

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "lib/base/parallel.h"
#include "lib/geom/vec.h"
#include "lib/hierarchy/blocks.h"
#include "lib/mesh/indexed_mesh.h"

// The tree over the triangles of one or more meshes has up to sixteen children in a node and sixteen triangles in a
// leaf. It is in single precision and stored by coordinate, so that one instruction examines all of them. A child has
// two bounds. One is a ball. The other is a disc whose direction is near the surface's own normal; it is thin if the
// surface is nearly flat. First-order bounds need the disc: a surface lying along the tool then costs one node, not its
// area.
// Source: bounding volume hierarchies in thesis 2.3 and 4.6. The oriented disc replaces the k-DOP slab pairs
// (docs/decisions/0006_oriented_discs.md). Wide nodes as in ray tracing (Wald, Benthin, Boulos 2008).

namespace gouge {

struct BlockTree {
  std::vector<NodeBlock> nodes;  ///< nodes[0] is the root; empty without triangles
  std::vector<TriangleBlock> leaves;
  Vec3 origin = Vec3::Zero();  ///< mm, part coordinates
  double radius_mm = 0;        ///< maximum distance of a triangle's points from the origin
  /// Maximum distance by which single precision may have moved a corner of a TriangleBlock.
  double rounding_mm = 0;
  std::vector<const IndexedMesh*> meshes;     ///< as passed to build_block_tree
  std::vector<std::uint32_t> first_triangle;  ///< for each mesh: number of triangles in the meshes before it

  [[nodiscard]] std::size_t mesh_of(std::uint32_t triangle) const;
  /// Returns the exact corners in part coordinates.
  [[nodiscard]] std::array<Vec3, 3> corners(std::uint32_t triangle) const;
  /// Returns the index of the triangle in the mesh's own file.
  [[nodiscard]] std::uint32_t file_triangle(std::uint32_t triangle) const;
};

/// Builds the tree. The meshes must outlive it and have fewer than 2^32 triangles together.
/// Ensures  Every triangle is in exactly one leaf, and every bound holds. The bytes are the same at any number of
///          threads (0: all).
/// Cost     O(n log n) time; 47 bytes for each triangle, and 16 more during the build. Progress is reported as `stage`,
///          counted in triangles.
[[nodiscard]] BlockTree build_block_tree(std::span<const IndexedMesh> meshes, unsigned threads = 0,
                                         std::string_view stage = {}, const ProgressCall& progress = {});

}  // namespace gouge

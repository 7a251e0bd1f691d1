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

// The tree over the triangles of one or more meshes: sixteen children a node and sixteen triangles a leaf. It is in
// single precision and by coordinate, so that one instruction examines all of them. A child is bounded twice. One bound
// is a ball. The other is a disc whose direction is near the surface's own normal, thin where the surface is nearly
// flat. First-order bounds need the disc: a surface lying along the tool costs one node, not its area.
// Source: bounding volume hierarchies in thesis 2.3 and 4.6. The oriented disc is in place of the k-DOP slab pairs
// (docs/decisions/0006_oriented_discs.md). Wide nodes as in ray tracing (Wald, Benthin, Boulos 2008).

namespace gouge {

struct BlockTree {
  std::vector<NodeBlock> nodes;  ///< nodes[0] is the root; empty when there is no triangle
  std::vector<TriangleBlock> leaves;
  Vec3 origin = Vec3::Zero();  ///< mm, part coordinates
  double radius_mm = 0;        ///< no triangle reaches farther from the origin
  /// Maximum distance by which single precision may have moved a corner of a TriangleBlock.
  double rounding_mm = 0;
  std::vector<const IndexedMesh*> meshes;     ///< as given to build_block_tree
  std::vector<std::uint32_t> first_triangle;  ///< per mesh: how many triangles are in those before it

  [[nodiscard]] std::size_t mesh_of(std::uint32_t triangle) const;
  /// Returns the exact corners, part coordinates.
  [[nodiscard]] std::array<Vec3, 3> corners(std::uint32_t triangle) const;
  /// Returns the index of the triangle in the mesh's own file.
  [[nodiscard]] std::uint32_t file_triangle(std::uint32_t triangle) const;
};

/// Requires that the meshes outlive the tree and hold fewer than 2^32 triangles together.
/// Ensures  Every triangle in exactly one leaf, every bound holds; the same bytes at any number of threads (0: all).
/// Cost     O(n log n) time, 47 bytes a triangle, 16 more while it is built. It is reported as `stage`, triangles
///          counted.
[[nodiscard]] BlockTree build_block_tree(std::span<const IndexedMesh> meshes, unsigned threads = 0,
                                         std::string_view stage = {}, const ProgressCall& progress = {});

}  // namespace gouge

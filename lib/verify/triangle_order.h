#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "lib/mesh/indexed_mesh.h"
#include "lib/verify/claims.h"

namespace gouge {

/// All triangles of a set of meshes, in an order in which near triangles follow one another. A node is a range of that
/// order. Its two children are the halves of the range. So the order alone defines the whole hierarchy, and a proof
/// does not need to contain it.
class TriangleOrder {
 public:
  struct Node {
    std::uint32_t first = 0, last = 0;  ///< [first, last)
    [[nodiscard]] std::uint32_t size() const { return last - first; }
    [[nodiscard]] std::uint32_t middle() const { return first + (last - first) / 2; }
  };

  /// Bounds of the triangles of a node with at least two triangles.
  struct Extent {
    Vec3 center = Vec3::Zero(), half = Vec3::Zero();  ///< every corner is within center +- half
    Vec3 into = Vec3::Zero();                         ///< approximate unit normal into the solid; zero: the normals
                                                      ///< differ too much
    double least = 0;                                 ///< minimum of into . p
  };

  /// The meshes must outlive the object. Requires finite vertices. Cost: O(n log n), about 130 bytes a triangle.
  explicit TriangleOrder(std::span<const IndexedMesh> meshes);

  [[nodiscard]] Node root() const { return {0, static_cast<std::uint32_t>(order_.size())}; }
  [[nodiscard]] const Extent& extent(const Node& node) const { return extents_[node.middle()]; }
  /// Returns the corners of the triangle at a position of the order.
  [[nodiscard]] std::array<Vec3, 3> corners(std::uint32_t place) const;

 private:
  struct Named {
    std::uint32_t mesh = 0, triangle = 0;
  };
  void sort(const Node& node, std::vector<Vec3>& centers, std::vector<std::uint32_t>& order);
  Box3 bound(const Node& node);

  std::span<const IndexedMesh> meshes_;
  std::vector<Named> order_;
  std::vector<Extent> extents_;  // by the middle of the node, which is different for each node
};

/// The triangle orders of all parts and of all fixtures of a scene. The scene must outlive them.
struct SceneOrders {
  explicit SceneOrders(const ClaimedScene& scene) : parts(scene.parts), fixtures(scene.fixtures) {
    for (const ClaimedLimit& limit : scene.limits)
      limited.emplace_back((limit.is_fixture ? scene.fixtures : scene.parts).subspan(limit.mesh, 1));
  }
  TriangleOrder parts, fixtures;
  std::vector<TriangleOrder> limited;  ///< one for each limit of the scene, of its mesh alone
};

}  // namespace gouge

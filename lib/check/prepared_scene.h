#pragma once

#include <deque>
#include <span>
#include <vector>

#include "lib/check/scene.h"
#include "lib/check/scene_sides.h"
#include "lib/check/verdict.h"
#include "lib/hierarchy/block_tree.h"
#include "lib/surface/surface.h"

namespace gouge {

/// An obstacle with its index and its surfaces.
struct PreparedObstacle {
  ContactRule rule;
  std::span<const IndexedMesh> meshes;
  BlockTree tree;                 ///< of all meshes, for the sweep
  std::vector<Surface> surfaces;  ///< one a mesh
};

/// A mesh with limits of its own.
struct LimitedMesh {
  MeshLimit limit;
  const PreparedObstacle* obstacle;
  const BlockTree* tree;  ///< of this mesh alone
};

/// The scene with each index of its meshes. The trees of the sweep are built at once. Every other index is built when
/// it is first requested, once, from any thread.
class PreparedScene {
 public:
  /// Requires that the scene outlives it. `threads` as in for_each_chunk.
  explicit PreparedScene(const Scene& scene, unsigned threads = 0, const ProgressCall& progress = {});
  /// Stays where it is: its surfaces point into its trees.
  PreparedScene(const PreparedScene&) = delete;
  PreparedScene& operator=(const PreparedScene&) = delete;

  /// Returns the obstacles in the order of the contact table.
  [[nodiscard]] std::span<const PreparedObstacle> obstacles() const { return obstacles_; }
  [[nodiscard]] const PreparedObstacle& obstacle(Against against) const {
    return obstacles_[static_cast<std::size_t>(against)];
  }
  /// Returns the obstacle whose surface the cutter makes.
  [[nodiscard]] const PreparedObstacle& workpiece() const;

  [[nodiscard]] const BlockTree& workpiece_tree() const { return workpiece().tree; }

  /// Returns the meshes with limits of their own, in the order of Scene::limits.
  [[nodiscard]] std::span<const LimitedMesh> limited_meshes() const { return limited_; }

  /// Distances from a mesh. Its index is that of the sweep where the obstacle has no other mesh. Requires
  /// is_within_reach. Cost of the first call for a mesh: else its tree.
  [[nodiscard]] const Surface& surface(Against against, std::size_t mesh) const {
    return obstacle(against).surfaces[mesh];
  }

  /// Returns whether every mesh of the workpiece is closed, oriented and outward. Cost of the first call O(n).
  [[nodiscard]] bool is_workpiece_solid() const;

  /// Returns inside and outside of all obstacles.
  [[nodiscard]] const SceneSides& sides() const { return sides_; }

  const Scene* scene;
  bool is_within_reach;  ///< no mesh reaches beyond kFarthest_mm

 private:
  void prepare_limits(unsigned threads, const ProgressCall& progress);

  std::vector<PreparedObstacle> obstacles_;
  std::deque<BlockTree> trees_of_limited_;  // where a mesh is not alone in its obstacle
  std::vector<LimitedMesh> limited_;
  SceneSides sides_;
};

[[nodiscard]] inline PreparedScene prepare_scene(const Scene& scene, unsigned threads = 0) {
  return PreparedScene(scene, threads);
}

}  // namespace gouge

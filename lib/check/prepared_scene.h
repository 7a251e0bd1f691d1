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

/// An obstacle with its contact rule and the indices of its meshes.
struct PreparedObstacle {
  ContactRule rule;
  std::span<const IndexedMesh> meshes;
  BlockTree tree;                 ///< tree of all meshes, for the sweep
  std::vector<Surface> surfaces;  ///< one for each mesh
};

/// A mesh with its own limits.
struct LimitedMesh {
  MeshLimit limit;
  const PreparedObstacle* obstacle;
  const BlockTree* tree;  ///< tree of this mesh alone
};

/// The scene with all indices of its meshes. The trees of the sweep are built at once. Every other index is built once,
/// when it is first requested; any thread may request it.
class PreparedScene {
 public:
  /// Builds the trees of the sweep. The scene must outlive the object. `threads` has the meaning of for_each_chunk.
  explicit PreparedScene(const Scene& scene, unsigned threads = 0, const ProgressCall& progress = {});
  /// The object cannot be copied: its surfaces point into its trees.
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

  /// Returns the meshes with their own limits, in the order of Scene::limits.
  [[nodiscard]] std::span<const LimitedMesh> limited_meshes() const { return limited_; }

  /// Returns the surface of a mesh, for distances from it. It uses the tree of the sweep if the obstacle has no other
  /// mesh. Otherwise the first call for a mesh builds its tree. Requires is_within_reach.
  [[nodiscard]] const Surface& surface(Against against, std::size_t mesh) const {
    return obstacle(against).surfaces[mesh];
  }

  /// Returns whether every mesh of the workpiece is closed, oriented and outward. The first call costs O(n).
  [[nodiscard]] bool is_workpiece_solid() const;

  /// Returns the object that decides inside and outside of all obstacles.
  [[nodiscard]] const SceneSides& sides() const { return sides_; }

  const Scene* scene;
  bool is_within_reach;  ///< no mesh reaches beyond kFarthest_mm

 private:
  void prepare_limits(unsigned threads, const ProgressCall& progress);

  std::vector<PreparedObstacle> obstacles_;
  std::deque<BlockTree> trees_of_limited_;  // trees of meshes with limits that are not alone in their obstacle
  std::vector<LimitedMesh> limited_;
  SceneSides sides_;
};

[[nodiscard]] inline PreparedScene prepare_scene(const Scene& scene, unsigned threads = 0) {
  return PreparedScene(scene, threads);
}

}  // namespace gouge

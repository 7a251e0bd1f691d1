#pragma once

#include <vector>

#include "lib/check/scene.h"
#include "lib/check/scene_sides.h"
#include "lib/check/verdict.h"
#include "lib/hierarchy/block_tree.h"
#include "lib/surface/surface.h"

namespace gouge {

/// The scene with each index of its meshes, made once whoever asks: the trees of the sweep at once, all else when first
/// asked for, from any thread.
class PreparedScene {
 public:
  /// Requires that the scene outlives it. `threads` as in for_each_chunk.
  explicit PreparedScene(const Scene& scene, unsigned threads = 0, const ProgressCall& progress = {});
  /// Stays where it is: its surfaces point into its trees.
  PreparedScene(const PreparedScene&) = delete;
  PreparedScene& operator=(const PreparedScene&) = delete;

  /// Distances from a mesh. Its index is that of the sweep where no other mesh is of that kind. Requires
  /// is_within_reach. Cost of the first call for a mesh: else its tree.
  [[nodiscard]] const Surface& surface(Against kind, std::size_t mesh) const;

  /// Every part is closed, oriented and outward. Cost of the first call O(n).
  [[nodiscard]] bool are_parts_solid() const;

  /// Inside and outside of parts and fixtures.
  [[nodiscard]] const SceneSides& sides() const { return sides_; }

  const Scene* scene;
  BlockTree parts, fixtures;
  bool is_within_reach;  ///< no mesh reaches beyond kFarthest_mm

 private:
  std::vector<Surface> part_surfaces_, fixture_surfaces_;
  SceneSides sides_;
};

[[nodiscard]] inline PreparedScene prepare_scene(const Scene& scene, unsigned threads = 0) {
  return PreparedScene(scene, threads);
}

}  // namespace gouge

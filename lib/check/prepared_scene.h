#pragma once

#include <memory>

#include "lib/check/scene.h"
#include "lib/check/scene_sides.h"
#include "lib/check/verdict.h"
#include "lib/hierarchy/block_tree.h"
#include "lib/penetration/depth_body.h"

namespace gouge {

/// The scene with each index of its meshes, made once whoever asks: the trees of the sweep at once, all else when first
/// asked for, from any thread.
class PreparedScene {
 public:
  /// Requires that the scene outlives it. `threads` as in for_each_chunk.
  explicit PreparedScene(const Scene& scene, unsigned threads = 0);
  PreparedScene(PreparedScene&&) noexcept;
  PreparedScene& operator=(PreparedScene&&) noexcept;
  ~PreparedScene();

  /// Distances from a mesh, on both sides where it is a solid: with closest_point, no depths. Requires
  /// is_within_reach. Cost of the first call for a mesh: its tree.
  [[nodiscard]] const DepthBody& surface(Against kind, std::size_t mesh) const;

  /// Inside and outside of parts and fixtures.
  [[nodiscard]] const SceneSides& sides() const;

  const Scene* scene;
  BlockTree parts, fixtures;
  bool is_within_reach;  ///< no mesh reaches beyond kFarthest_mm

 private:
  struct OnDemand;
  std::unique_ptr<OnDemand> on_demand_;
};

[[nodiscard]] inline PreparedScene prepare_scene(const Scene& scene, unsigned threads = 0) {
  return PreparedScene(scene, threads);
}

}  // namespace gouge

#pragma once

#include "lib/check/scene.h"
#include "lib/hierarchy/block_tree.h"

namespace gouge {

/// The scene with its trees.
struct PreparedScene {
  const Scene* scene = nullptr;
  BlockTree parts, fixtures;
  bool is_within_reach = true;  ///< no mesh reaches beyond kFarthest_mm
};

/// Requires that the scene outlives the result. `threads` as in for_each_chunk.
[[nodiscard]] PreparedScene prepare_scene(const Scene& scene, unsigned threads = 0);

}  // namespace gouge

#include "lib/check/prepared_scene.h"

#include "lib/check/reach.h"

namespace gouge {

PreparedScene prepare_scene(const Scene& scene, unsigned threads) {
  if (why_unfit(scene) != Reason::Kind::none) return {&scene, {}, {}, false};
  return {&scene, build_block_tree(scene.parts, threads), build_block_tree(scene.fixtures, threads)};
}

}  // namespace gouge

#include "lib/check/prepared_scene.h"

#include <algorithm>

#include "lib/check/reach.h"

namespace gouge {
namespace {

std::vector<Surface> surfaces_of(const std::vector<IndexedMesh>& meshes, const BlockTree& tree, unsigned threads) {
  if (meshes.size() == 1) return {Surface(meshes[0], tree)};
  std::vector<Surface> surfaces;
  surfaces.reserve(meshes.size());
  for (const IndexedMesh& mesh : meshes) surfaces.emplace_back(mesh, threads);
  return surfaces;
}

}  // namespace

PreparedScene::PreparedScene(const Scene& of, unsigned threads, const ProgressCall& progress)
    : scene(&of),
      is_within_reach(why_unfit(of) == Reason::Kind::none),
      part_surfaces_(surfaces_of(of.parts, parts, threads)),
      fixture_surfaces_(surfaces_of(of.fixtures, fixtures, threads)),
      sides_(of) {
  if (!is_within_reach) return;
  parts = build_block_tree(of.parts, threads, "indexing the parts", progress);
  fixtures = build_block_tree(of.fixtures, threads, "indexing the fixtures", progress);
}

bool PreparedScene::are_parts_solid() const {
  return std::ranges::all_of(part_surfaces_, [](const Surface& surface) { return surface.is_solid(); });
}

const Surface& PreparedScene::surface(Against kind, std::size_t mesh) const {
  return (kind == Against::part ? part_surfaces_ : fixture_surfaces_)[mesh];
}

}  // namespace gouge

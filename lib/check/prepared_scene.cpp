#include "lib/check/prepared_scene.h"

#include <algorithm>
#include <string>

#include "lib/check/reach.h"

namespace gouge {
namespace {

std::vector<Surface> surfaces_of(std::span<const IndexedMesh> meshes, const BlockTree& tree, unsigned threads) {
  std::vector<Surface> surfaces;
  surfaces.reserve(meshes.size());
  if (meshes.size() == 1) {
    surfaces.emplace_back(meshes[0], tree);
  } else {
    for (const IndexedMesh& mesh : meshes) surfaces.emplace_back(mesh, threads);
  }
  return surfaces;
}

}  // namespace

PreparedScene::PreparedScene(const Scene& of, unsigned threads, const ProgressCall& progress)
    : scene(&of), is_within_reach(why_unfit(of) == Reason::Kind::none), sides_(of) {
  for (const ObstacleMeshes& from : obstacles_of(of)) obstacles_.push_back({from.rule, from.meshes, {}, {}});
  for (PreparedObstacle& obstacle : obstacles_) {
    if (is_within_reach) {
      const std::string what = "indexing the " + std::string(obstacle.rule.name) + "s";
      obstacle.tree = build_block_tree(obstacle.meshes, threads, what.c_str(), progress);
    }
    obstacle.surfaces = surfaces_of(obstacle.meshes, obstacle.tree, threads);
  }
  if (is_within_reach) prepare_limits(threads, progress);
}

void PreparedScene::prepare_limits(unsigned threads, const ProgressCall& progress) {
  for (const MeshLimit& limit : scene->limits) {
    const PreparedObstacle& of = obstacle(limit.against);
    const BlockTree* tree = &of.tree;
    if (of.meshes.size() > 1) {
      trees_of_limited_.push_back(
          build_block_tree(of.meshes.subspan(limit.mesh, 1), threads, "indexing limited meshes", progress));
      tree = &trees_of_limited_.back();
    }
    limited_.push_back({limit, &of, tree});
  }
}

const PreparedObstacle& PreparedScene::workpiece() const {
  return *std::ranges::find_if(obstacles_, [](const PreparedObstacle& one) { return one.rule.is_workpiece; });
}

bool PreparedScene::is_workpiece_solid() const {
  return std::ranges::all_of(workpiece().surfaces, [](const Surface& surface) { return surface.is_solid(); });
}

}  // namespace gouge

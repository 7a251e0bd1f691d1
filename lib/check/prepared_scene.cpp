#include "lib/check/prepared_scene.h"

#include <mutex>
#include <optional>
#include <vector>

#include "lib/check/reach.h"

namespace gouge {

struct PreparedScene::OnDemand {
  struct Slot {
    std::once_flag once;
    std::optional<Surface> surface;
  };

  explicit OnDemand(const Scene& scene) : parts(scene.parts.size()), fixtures(scene.fixtures.size()), sides(scene) {}

  std::vector<Slot> parts, fixtures;
  SceneSides sides;  // its own indices are made when first needed
};

PreparedScene::PreparedScene(const Scene& of, unsigned threads)
    : scene(&of),
      is_within_reach(why_unfit(of) == Reason::Kind::none),
      on_demand_(std::make_unique<OnDemand>(of)),
      threads_(threads) {
  if (!is_within_reach) return;
  parts = build_block_tree(of.parts, threads);
  fixtures = build_block_tree(of.fixtures, threads);
}

PreparedScene::~PreparedScene() = default;

const Surface& PreparedScene::surface(Against kind, std::size_t mesh) const {
  const bool is_part = kind == Against::part;
  OnDemand::Slot& slot = (is_part ? on_demand_->parts : on_demand_->fixtures)[mesh];
  std::call_once(slot.once, [&] {
    const std::vector<IndexedMesh>& meshes = is_part ? scene->parts : scene->fixtures;
    if (meshes.size() == 1) {
      slot.surface.emplace(meshes[mesh], is_part ? parts : fixtures);
    } else {
      slot.surface.emplace(meshes[mesh], threads_);
    }
  });
  return *slot.surface;
}

const SceneSides& PreparedScene::sides() const { return on_demand_->sides; }

}  // namespace gouge

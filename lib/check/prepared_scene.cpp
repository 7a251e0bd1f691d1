#include "lib/check/prepared_scene.h"

#include <mutex>
#include <optional>
#include <vector>

#include "lib/check/reach.h"

namespace gouge {

struct PreparedScene::OnDemand {
  struct Surface {
    std::once_flag once;
    std::optional<DepthBody> body;
  };

  explicit OnDemand(const Scene& scene) : parts(scene.parts.size()), fixtures(scene.fixtures.size()), sides(scene) {}

  std::vector<Surface> parts, fixtures;
  SceneSides sides;  // its own indices are made when first needed
};

PreparedScene::PreparedScene(const Scene& of, unsigned threads)
    : scene(&of), is_within_reach(why_unfit(of) == Reason::Kind::none), on_demand_(std::make_unique<OnDemand>(of)) {
  if (!is_within_reach) return;
  parts = build_block_tree(of.parts, threads);
  fixtures = build_block_tree(of.fixtures, threads);
}

PreparedScene::PreparedScene(PreparedScene&&) noexcept = default;
PreparedScene& PreparedScene::operator=(PreparedScene&&) noexcept = default;
PreparedScene::~PreparedScene() = default;

const DepthBody& PreparedScene::surface(Against kind, std::size_t mesh) const {
  const bool is_part = kind == Against::part;
  OnDemand::Surface& own = (is_part ? on_demand_->parts : on_demand_->fixtures)[mesh];
  std::call_once(own.once, [&] { own.body = build_distance_body((is_part ? scene->parts : scene->fixtures)[mesh]); });
  return *own.body;
}

const SceneSides& PreparedScene::sides() const { return on_demand_->sides; }

}  // namespace gouge

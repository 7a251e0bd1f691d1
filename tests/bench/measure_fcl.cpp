#include <memory>

#include "tests/bench/fcl_model.h"
#include "tests/bench/peer_support.h"

// FCL: trees of oriented boxes on both sides, the tool tessellated to 0.01 mm, which of FCL's forms grows
// least with the part. Yes or no at single poses; for motions ten steps, and at the smallest mesh its own
// conservative advancement.

namespace gouge::bench {
namespace {

constexpr double kChord_mm = 0.01;
constexpr int kSteps = 10;

struct FclScene {
  std::shared_ptr<FclModel> part, tool;

  [[nodiscard]] bool is_hit(const Pose& pose) const {
    fcl::CollisionRequestd request;
    fcl::CollisionResultd result;
    return fcl::collide(tool.get(), fcl_transform(pose, pose), part.get(), fcl::Transform3d::Identity(), request,
                        result) > 0;
  }

  [[nodiscard]] bool is_hit_in_steps(const Motion& motion) const {
    for (int k = 0; k < kSteps; ++k) {
      if (is_hit(motion.at((k + 1.0) / kSteps))) return true;
    }
    return false;
  }

  [[nodiscard]] bool is_hit_advancing(const Motion& motion) const {
    fcl::ContinuousCollisionRequestd request;
    request.gjk_solver_type = fcl::GST_LIBCCD;
    request.ccd_motion_type = fcl::CCDM_LINEAR;
    request.ccd_solver_type = fcl::CCDC_CONSERVATIVE_ADVANCEMENT;
    fcl::ContinuousCollisionResultd result;
    const fcl::Transform3d still = fcl::Transform3d::Identity();
    fcl::continuousCollide(tool.get(), fcl_transform(motion.start(), motion.start()),
                           fcl_transform(motion.end(), motion.start()), part.get(), still, still, request, result);
    return result.is_collide;
  }
};

std::shared_ptr<FclScene> make_scene(const PeerCase& c) {
  return std::make_shared<FclScene>(
      FclScene{make_fcl_model(c.work.scene.parts[0]), make_fcl_model(tessellate_tool(c.work.tool, kChord_mm))});
}

std::function<void(benchmark::State&)> prepare_poses(const std::shared_ptr<const PeerCase>& c) {
  const auto scene = make_scene(*c);
  const auto sample = sample_poses(*c, scaled(2000));
  return [=](benchmark::State& state) {
    time_poses(
        state, *c, sample, [&](const Pose& pose) { return scene->is_hit(pose) ? 1.0 : 0.0; }, true);
  };
}

std::function<void(benchmark::State&)> prepare_steps(const std::shared_ptr<const PeerCase>& c) {
  const auto scene = make_scene(*c);
  const auto sample = sample_moves(*c, scaled(800));
  return [=](benchmark::State& state) {
    time_moves(state, sample, [&](const Motion& motion) { return scene->is_hit_in_steps(motion); });
  };
}

std::function<void(benchmark::State&)> prepare_advancing(const std::shared_ptr<const PeerCase>& c) {
  const auto scene = make_scene(*c);
  const auto sample = sample_moves(*c, scaled(80));
  return [=](benchmark::State& state) {
    time_moves(state, sample, [&](const Motion& motion) { return scene->is_hit_advancing(motion); });
  };
}

}  // namespace
}  // namespace gouge::bench

int main(int count, char** words) {
  using namespace gouge::bench;
  register_measurements(
      {{"fcl.pose", prepare_poses}, {"fcl.ten_steps", prepare_steps}, {"fcl.advancement", prepare_advancing, 2400}});
  return run_measurements(count, words);
}

#include <fcl/fcl.h>

#include <memory>
#include <vector>

#include "tests/bench/peer_support.h"

// FCL: trees of oriented boxes on both sides, the tool tessellated to 0.01 mm, which of FCL's forms grows
// least with the part. Yes or no at single poses; for motions ten steps, and at the smallest mesh its own
// conservative advancement.

namespace gouge::bench {
namespace {

constexpr double kChord_mm = 0.01;
constexpr int kSteps = 10;

using Model = fcl::BVHModel<fcl::OBBRSSd>;

std::shared_ptr<Model> make_model(const IndexedMesh& mesh) {
  std::vector<fcl::Triangle> triangles;
  for (const TriangleCorners& t : mesh.triangles) triangles.emplace_back(t[0], t[1], t[2]);
  auto model = std::make_shared<Model>();
  model->beginModel(static_cast<int>(triangles.size()), static_cast<int>(mesh.vertices.size()));
  model->addSubModel(mesh.vertices, triangles);
  model->endModel();
  return model;
}

fcl::Transform3d transform_of(const Pose& pose, const Pose& like) {
  // Turned from one fixed frame, so that the way between two poses has no spin about the tool's axis.
  fcl::Transform3d t = fcl::Transform3d::Identity();
  t.linear() = Eigen::Quaterniond::FromTwoVectors(like.axis, pose.axis).toRotationMatrix() * rotation_of(like.axis);
  t.translation() = pose.tip;
  return t;
}

struct FclScene {
  std::shared_ptr<Model> part, tool;

  [[nodiscard]] bool is_hit(const Pose& pose) const {
    fcl::CollisionRequestd request;
    fcl::CollisionResultd result;
    return fcl::collide(tool.get(), transform_of(pose, pose), part.get(), fcl::Transform3d::Identity(), request,
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
    fcl::continuousCollide(tool.get(), transform_of(motion.start(), motion.start()),
                           transform_of(motion.end(), motion.start()), part.get(), still, still, request, result);
    return result.is_collide;
  }
};

std::shared_ptr<FclScene> make_scene(const PeerCase& c) {
  return std::make_shared<FclScene>(
      FclScene{make_model(c.work.scene.parts[0]), make_model(tessellate_tool(c.work.tool, kChord_mm))});
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

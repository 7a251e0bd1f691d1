#include <benchmark/benchmark.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "lib/head/check_heads.h"
#include "lib/motion/body_motion.h"
#include "tests/bench/fcl_model.h"
#include "tests/bench/peer_support.h"
#include "tests/bench/scene_files.h"
#include "tests/support/motions.h"

// A machine head, given as a mesh, over contact moves of the wavy block: certified moves of ours beside FCL's exact
// distance, and its yes or no, at one pose each. Names: <measurement>/<facets of the head>/<mm from tip to head>.

namespace gouge::bench {
namespace {

constexpr std::size_t kMoves = 200;
constexpr std::size_t kTriangles = 2400;

struct HeadSize {
  int facets, around, steps;
};
constexpr std::array<HeadSize, 3> kHeads = {{{576, 24, 5}, {12544, 112, 27}, {50176, 224, 55}}};
constexpr std::array<int, 4> kHeights_mm = {40, 11, 9, 6};

/// The part and the path.
struct Work {
  Workload workload = make_workload({BenchPart::wavy, ToolKind::ball, kTriangles, 1});
  PreparedScene scene{workload.scene};
};

struct Heads {
  std::shared_ptr<const Work> work;
  std::vector<HeadBody> bodies;
  std::shared_ptr<FclModel> part, head;
  std::vector<Motion> motions;
};

std::shared_ptr<const Heads> prepare(const std::shared_ptr<const Work>& of, const HeadSize& size, int height_mm) {
  const Workload& work = of->workload;
  auto prepared = std::make_shared<Heads>();
  prepared->work = of;
  const IndexedMesh mesh = make_head(height_mm, size.around, size.steps);
  prepared->head = make_fcl_model(mesh);
  prepared->part = make_fcl_model(work.scene.parts[0]);
  prepared->bodies.push_back(*build_head_body(mesh));
  std::vector<std::size_t> contact;
  for (std::size_t i = 1; i < work.groups.size(); ++i) {
    if (work.groups[i] == MoveGroup::contact) contact.push_back(i);
  }
  for (std::size_t k = 0; k < kMoves; ++k) {
    const std::size_t i = contact[k * contact.size() / kMoves];
    prepared->motions.push_back(test::straight(work.positions[i - 1].pose, work.positions[i].pose));
  }
  return prepared;
}

void time_certified(benchmark::State& state, const Heads& heads) {
  const HeadChecker checker(heads.bodies, heads.work->scene);
  const CheckOptions options;
  std::size_t gouges = 0, open = 0, runs = 0;
  for ([[maybe_unused]] auto _ : state) {
    for (const Motion& motion : heads.motions) {
      MoveVerdict verdict;
      checker.check(motion, options, verdict);
      gouges += verdict.state == MoveState::gouge ? 1 : 0;
      open += verdict.state == MoveState::not_certified ? 1 : 0;
    }
    ++runs;
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(heads.motions.size()));
  state.counters["gouges"] = static_cast<double>(gouges) / static_cast<double>(runs);
  state.counters["not_certified"] = static_cast<double>(open) / static_cast<double>(runs);
}

fcl::Transform3d head_transform(const Pose& pose) {
  fcl::Transform3d t = fcl::Transform3d::Identity();
  t.linear() = rotation_to_axis(pose.axis);
  t.translation() = pose.tip;
  return t;
}

void time_distance(benchmark::State& state, const Heads& heads) {
  std::size_t touching = 0, runs = 0;
  for ([[maybe_unused]] auto _ : state) {
    for (const Motion& motion : heads.motions) {
      fcl::DistanceRequestd request;
      fcl::DistanceResultd result;
      fcl::distance(heads.head.get(), head_transform(motion.start()), heads.part.get(), fcl::Transform3d::Identity(),
                    request, result);
      touching += result.min_distance <= 0 ? 1 : 0;
    }
    ++runs;
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(heads.motions.size()));
  state.counters["touching"] = static_cast<double>(touching) / static_cast<double>(runs);
}

void time_collide(benchmark::State& state, const Heads& heads) {
  for ([[maybe_unused]] auto _ : state) {
    for (const Motion& motion : heads.motions) {
      fcl::CollisionRequestd request;
      fcl::CollisionResultd result;
      benchmark::DoNotOptimize(fcl::collide(heads.head.get(), head_transform(motion.start()), heads.part.get(),
                                            fcl::Transform3d::Identity(), request, result));
    }
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(heads.motions.size()));
}

void register_heads() {
  const auto work = std::make_shared<const Work>();
  for (const HeadSize& size : kHeads) {
    for (const int height : kHeights_mm) {
      const auto heads = prepare(work, size, height);
      const std::string of = "/" + std::to_string(size.facets) + "/" + std::to_string(height);
      using Timed = void (*)(benchmark::State&, const Heads&);
      const std::array<std::pair<const char*, Timed>, 3> all = {
          {{"head.certified", time_certified}, {"fcl.distance", time_distance}, {"fcl.collide", time_collide}}};
      for (const auto& [name, timed] : all) {
        benchmark::RegisterBenchmark((name + of).c_str(),
                                     [heads, timed = timed](benchmark::State& state) { timed(state, *heads); })
            ->MeasureProcessCPUTime()
            ->Unit(benchmark::kMillisecond);
      }
    }
  }
}

}  // namespace
}  // namespace gouge::bench

int main(int count, char** words) {
  benchmark::Initialize(&count, words);
  gouge::bench::register_heads();
  benchmark::RunSpecifiedBenchmarks();
}

#include <benchmark/benchmark.h>

#include <memory>

#include "lib/tool/evaluate.h"
#include "tests/bench/peer_support.h"
#include "tests/bench/verdict_hash.h"

// The engine itself: certified moves over whole paths, over the groups of their moves, at ten times as many
// positions and with two threads; and the floor, the exact distance evaluated once for the triangles that an
// oracle names.

namespace gouge::bench {
namespace {

constexpr double kFloorReach_mm = 0.01;  // a triangle this near must be examined, whatever the method
constexpr std::size_t kJudged = 400;     // moves whose verdict is compared with 65 instants

/// How many verdicts the truth contradicts: a gouge not reported, one reported that is not there, a bound too low.
void judge(benchmark::State& state, const CheckResult& result, const std::vector<SampledMove>& sample) {
  constexpr double kSlack_mm = 1e-5;
  Wrongs wrongs;
  std::size_t broken_bounds = 0;
  for (const SampledMove& s : sample) {
    const MoveVerdict& v = result.verdicts[s.move];
    wrongs.count(s.closest_mm, v.state == MoveState::gouge || v.state == MoveState::buried);
    const bool is_bounded = v.state == MoveState::clean || v.state == MoveState::gouge;
    if (is_bounded && v.depth_upper_mm < -s.closest_mm - kSlack_mm) ++broken_bounds;
  }
  wrongs.report(state);
  state.counters["broken_bounds"] = static_cast<double>(broken_bounds);
}

/// A path of a case with what checking it needs.
struct Prepared {
  Prepared(std::shared_ptr<const PeerCase> of, Toolpath along)
      : c(std::move(of)), path(std::move(along)), scene(c->work.scene) {}

  std::shared_ptr<const PeerCase> c;
  Toolpath path;
  PreparedScene scene;
};

CheckResult time_path(benchmark::State& state, const Prepared& p, unsigned threads) {
  CheckOptions options;
  options.threads = threads;
  CheckResult result;
  for ([[maybe_unused]] auto _ : state) {
    result = check_path(p.path, {&p.c->work.tool.variants}, p.scene, options);
    summarise(p.path, result);
    benchmark::DoNotOptimize(result);
  }
  const auto moves = static_cast<std::int64_t>(p.path.moves.size());
  state.SetItemsProcessed(state.iterations() * moves);
  state.counters["moves"] = static_cast<double>(moves);
  state.counters["evaluations"] = static_cast<double>(result.evaluations) / static_cast<double>(moves);
  state.counters["gouges"] = static_cast<double>(result.counts.gouge);
  state.counters["not_certified"] = static_cast<double>(result.counts.not_certified);
  // A counter is a double: 52 bits of the hash survive in it.
  state.counters["hash"] = static_cast<double>(VerdictHash(result).value() >> 12U);
  return result;
}

std::shared_ptr<Prepared> prepare(const std::shared_ptr<const PeerCase>& c, Toolpath path) {
  return std::make_shared<Prepared>(c, std::move(path));
}

std::function<void(benchmark::State&)> prepare_moves(const std::shared_ptr<const PeerCase>& c) {
  const auto p = prepare(c, c->work.path);
  const auto sample = sample_moves(*c, scaled(kJudged));
  return [=](benchmark::State& state) { judge(state, time_path(state, *p, 1), sample); };
}

std::function<void(benchmark::State&)> prepare_two_threads(const std::shared_ptr<const PeerCase>& c) {
  const auto p = prepare(c, c->work.path);
  return [=](benchmark::State& state) { time_path(state, *p, 2); };
}

std::function<void(benchmark::State&)> prepare_dense(const std::shared_ptr<const PeerCase>& c) {
  const auto p = prepare(c, c->work.path);
  return [=](benchmark::State& state) { time_path(state, *p, 1); };
}

Measurement group(MoveGroup group) {
  Measurement m;
  m.name = std::string("engine.") + group_name(group);
  m.prepare = [group](const std::shared_ptr<const PeerCase>& c) -> std::function<void(benchmark::State&)> {
    const auto p = prepare(c, only(c->work, group));
    return [=](benchmark::State& state) {
      if (p->path.moves.empty()) {
        state.SkipWithError("the path has no such moves");
        return;
      }
      time_path(state, *p, 1);
    };
  };
  return m;
}

/// Per sampled pose the corners of every triangle that comes within kFloorReach_mm of the tool.
std::vector<std::vector<Vec3>> corners_to_see(const PeerCase& c, const std::vector<SampledPose>& sample) {
  const IndexedMesh& mesh = c.work.scene.parts[0];
  const ExactDistance oracle(mesh);
  std::vector<std::vector<Vec3>> corners(sample.size());
  for (std::size_t i = 0; i < sample.size(); ++i) {
    const Pose& pose = c.work.positions[sample[i].position].pose;
    for (const ConvexPiece* piece : {&c.work.tool.lower, &c.work.tool.holder}) {
      for (const std::uint32_t t : oracle.triangles_below(*piece, pose, kFloorReach_mm)) {
        for (std::size_t k = 0; k < 3; ++k) corners[i].push_back(mesh.corner(t, k));
      }
    }
  }
  return corners;
}

std::function<void(benchmark::State&)> prepare_floor(const std::shared_ptr<const PeerCase>& c) {
  const auto sample = sample_poses(*c, scaled(2000));
  const auto corners = std::make_shared<std::vector<std::vector<Vec3>>>(corners_to_see(*c, sample));
  return [=](benchmark::State& state) {
    const CompiledTool& tool = c->work.tool.variants.against_part;
    std::size_t seen = 0;
    for ([[maybe_unused]] auto _ : state) {
      for (std::size_t i = 0; i < sample.size(); ++i) {
        const Pose& pose = c->work.positions[sample[i].position].pose;
        double least = 0;
        for (const Vec3& p : (*corners)[i]) {
          const Vec3 d = p - pose.tip;
          const double z = d.dot(pose.axis);
          least = std::min(least, evaluate(tool, (d - z * pose.axis).norm(), z).signed_distance_mm);
        }
        benchmark::DoNotOptimize(least);
      }
    }
    for (const auto& list : *corners) seen += list.size() / 3;
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(sample.size()));
    state.counters["triangles"] = static_cast<double>(seen) / static_cast<double>(sample.size());
  };
}

}  // namespace
}  // namespace gouge::bench

int main(int count, char** words) {
  using namespace gouge::bench;
  const std::size_t dense_size = is_quick() ? 2400 : 200000;
  register_measurements({{"engine.moves", prepare_moves},
                         {"engine.two_threads", prepare_two_threads},
                         group(MoveGroup::contact),
                         group(MoveGroup::air),
                         group(MoveGroup::gouge),
                         group(MoveGroup::holder),
                         {"floor.pose", prepare_floor},
                         {"engine.dense", prepare_dense, dense_size, dense_size, 10}});
  return run_measurements(count, words);
}

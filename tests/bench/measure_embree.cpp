#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <memory>
#include <string>

#include "tests/bench/peer_support.h"
#include "tests/bench/sphere_cover.h"

// Embree: the tool is covered by spheres, a point query for each names the triangles near it, and an exact
// narrow phase finds the depth. Single poses; the covering that is fastest for the case is taken.

namespace gouge::bench {
namespace {

/// GOUGE_BENCH_THREADS (1) threads: only building the tree uses more than one.
std::string device_text() {
  const char* threads = std::getenv("GOUGE_BENCH_THREADS");
  return std::string("threads=") + (threads != nullptr ? threads : "1");
}

struct Device {
  RTCDevice device = rtcNewDevice(device_text().c_str());
  ~Device() { rtcReleaseDevice(device); }
};

/// The triangles of a part under Embree's tree of medium quality.
class EmbreeScene {
 public:
  explicit EmbreeScene(const IndexedMesh& mesh)
      : mesh_(mesh), scene_(rtcNewScene(device_.device)), seen_(mesh.triangles.size(), 0) {
    const RTCGeometry geometry = rtcNewGeometry(device_.device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* corners = static_cast<float*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, mesh.vertices.size()));
    for (const Vec3& v : mesh.vertices) {
      for (int k = 0; k < 3; ++k) *corners++ = static_cast<float>(v[k]);
    }
    auto* indices = static_cast<unsigned*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, mesh.triangles.size()));
    for (const TriangleCorners& t : mesh.triangles) indices = std::copy(t.begin(), t.end(), indices);
    rtcSetGeometryPointQueryFunction(geometry, nullptr);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_MEDIUM);
    rtcCommitScene(scene_);
  }
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;
  ~EmbreeScene() { rtcReleaseScene(scene_); }

  double depth(const BenchTool& tool, const SphereCover& cover, const Pose& pose) const {
    const Eigen::Matrix3d turn = rotation_of(pose.axis);
    double deepest = 0;
    // Several spheres may name a triangle; each is examined once for each piece.
    if (stamp_ > 4000000000U) {
      std::fill(seen_.begin(), seen_.end(), 0U);
      stamp_ = 0;
    }
    for (const auto& [piece, spheres] : {std::pair{&tool.lower, &cover.lower}, {&tool.holder, &cover.holder}}) {
      Asked asked = {&mesh_, piece, &pose, seen_.data(), ++stamp_, {}};
      asked.best.distance_mm = -deepest;
      for (const CoverSphere& s : *spheres) {
        const Vec3 center = pose.tip + turn * s.center;
        RTCPointQuery query = {static_cast<float>(center.x()), static_cast<float>(center.y()),
                               static_cast<float>(center.z()), 0, static_cast<float>(s.radius_mm)};
        RTCPointQueryContext context;
        rtcInitPointQueryContext(&context);
        rtcPointQuery(scene_, &query, &context, &EmbreeScene::near_triangle, &asked);
      }
      deepest = -asked.best.distance_mm;
    }
    return deepest;
  }

 private:
  struct Asked {
    const IndexedMesh* mesh;
    const ConvexPiece* piece;
    const Pose* pose;
    std::uint32_t* seen;
    std::uint32_t stamp;
    TriangleMinimum best;
  };

  static bool near_triangle(RTCPointQueryFunctionArguments* arguments) {
    auto& asked = *static_cast<Asked*>(arguments->userPtr);
    const std::size_t t = arguments->primID;
    if (asked.seen[t] == asked.stamp) return false;
    asked.seen[t] = asked.stamp;
    lower_over_triangle(*asked.piece, *asked.pose,
                        {asked.mesh->corner(t, 0), asked.mesh->corner(t, 1), asked.mesh->corner(t, 2)}, 1e-4,
                        asked.best);
    return false;
  }

  Device device_;
  const IndexedMesh& mesh_;
  RTCScene scene_;
  mutable std::vector<std::uint32_t> seen_;
  mutable std::uint32_t stamp_ = 0;
};

/// The fastest of some coverings, by a short trial over poses of this very case.
SphereCover fastest_cover(const EmbreeScene& scene, const PeerCase& c, const std::vector<SampledPose>& sample) {
  SphereCover best;
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [bulge, disc] : {std::pair{0.04, 0.15},
                                    {0.08, 0.3},
                                    {0.08, 0.6},
                                    {0.15, 0.6},
                                    {0.3, 0.6},
                                    {0.3, 1.2},
                                    {0.6, 1.2},
                                    {1.2, 1.2},
                                    {2.0, 2.0},
                                    {2.0, 4.0},
                                    {4.0, 4.0},
                                    {8.0, 12.0}}) {
    const SphereCover cover = cover_tool(c.work.tool, bulge, disc);
    const std::clock_t start = std::clock();
    for (std::size_t i = 0; i < sample.size(); i += 7) {
      benchmark::DoNotOptimize(scene.depth(c.work.tool, cover, c.work.positions[sample[i].position].pose));
    }
    const auto time = static_cast<double>(std::clock() - start);
    if (time >= least) continue;
    least = time;
    best = cover;
  }
  return best;
}

/// With `is_tuned` false the covering that suits coarse meshes best, whatever the mesh.
std::function<void(benchmark::State&)> prepare(const std::shared_ptr<const PeerCase>& c, bool is_tuned) {
  constexpr double kCoarse_mm = 1.2;
  const auto scene = std::make_shared<EmbreeScene>(c->work.scene.parts[0]);
  const auto sample = sample_poses(*c, scaled(8000));
  const SphereCover cover =
      is_tuned ? fastest_cover(*scene, *c, sample) : cover_tool(c->work.tool, kCoarse_mm, kCoarse_mm);
  return [=](benchmark::State& state) {
    time_poses(
        state, *c, sample, [&](const Pose& pose) { return scene->depth(c->work.tool, cover, pose); }, false);
    state.counters["spheres"] = static_cast<double>(cover.lower.size() + cover.holder.size());
    state.counters["bulge_mm"] = cover.bulge_mm;
  };
}

std::function<void(benchmark::State&)> prepare_poses(const std::shared_ptr<const PeerCase>& c) {
  return prepare(c, true);
}

std::function<void(benchmark::State&)> prepare_untuned(const std::shared_ptr<const PeerCase>& c) {
  return prepare(c, false);
}

std::function<void(benchmark::State&)> prepare_build(const std::shared_ptr<const PeerCase>& c) {
  return [=](benchmark::State& state) {
    for ([[maybe_unused]] auto _ : state) {
      const EmbreeScene scene(c->work.scene.parts[0]);
      benchmark::DoNotOptimize(&scene);
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(c->work.scene.parts[0].triangles.size()));
  };
}

}  // namespace
}  // namespace gouge::bench

int main(int count, char** words) {
  using namespace gouge::bench;
  register_measurements({{"embree.pose", prepare_poses},
                         {"embree.one_cover", prepare_untuned},
                         {"embree.build", prepare_build, 2000000, 2000000, 1, false}});
  return run_measurements(count, words);
}

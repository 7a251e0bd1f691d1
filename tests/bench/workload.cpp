#include "tests/bench/workload.h"

#include <array>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string_view>

#include "lib/base/files.h"

namespace gouge::bench {
namespace {

// Names the recipe in the names of the cached files; count it up whenever a plan or its placing changes.
constexpr const char* kRecipe = "r4";
constexpr double kGouge_mm = 0.01;
constexpr std::size_t kNumbers = 9;  // doubles a cached position has

PartPlan plan_of(BenchPart part) { return part == BenchPart::wavy ? plan_wavy() : plan_unseen(); }

std::string cache_file(const PartPlan& plan, const BenchTool& tool, const WorkloadKey& key) {
  const char* folder = std::getenv("GOUGE_BENCH_CACHE");
  if (folder == nullptr || *folder == '\0') return {};
  return std::string(folder) + "/" + plan.name + "_" + tool.name + "_" + std::to_string(key.triangles) + "_x" +
         std::to_string(key.density) + "_" + kRecipe + ".poses";
}

std::string bytes_of(const std::vector<PlacedPose>& positions) {
  std::vector<double> numbers;
  for (const PlacedPose& p : positions) {
    const Vec3 &t = p.pose.tip, &a = p.pose.axis;
    numbers.insert(numbers.end(), {t.x(), t.y(), t.z(), a.x(), a.y(), a.z(), p.lower_mm, p.holder_mm, p.is_air});
  }
  std::string bytes(numbers.size() * sizeof(double), '\0');
  std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return bytes;
}

bool read_positions(const std::string& file, std::size_t count, std::vector<PlacedPose>& positions) {
  if (file.empty() || !std::filesystem::exists(file)) return false;
  const Result<std::string> bytes = read_file(file);
  if (!bytes || bytes.value().size() != count * kNumbers * sizeof(double)) return false;
  positions.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    std::array<double, kNumbers> n{};
    std::memcpy(n.data(), bytes.value().data() + i * sizeof(n), sizeof(n));
    positions[i] = {{Vec3(n[0], n[1], n[2]), Vec3(n[3], n[4], n[5])}, n[6], n[7], n[8]};
  }
  return true;
}

MoveGroup group_of(const PlacedPose& a, const PlacedPose& b) {
  if (a.holder_mm < -kGouge_mm || b.holder_mm < -kGouge_mm) return MoveGroup::holder;
  if (a.lower_mm < -kGouge_mm || b.lower_mm < -kGouge_mm) return MoveGroup::gouge;
  const bool is_air_a = a.is_air > 0, is_air_b = b.is_air > 0;
  if (is_air_a && is_air_b) return MoveGroup::air;
  return is_air_a || is_air_b ? MoveGroup::link : MoveGroup::contact;
}

void add_moves(Workload& work) {
  work.path.file = "bench";
  work.path.dialect = "apt";
  work.path.tools.resize(1);
  work.path.tools[0].number = 1;
  for (std::size_t i = 0; i < work.positions.size(); ++i) {
    const PlacedPose& here = work.positions[i];
    const PlacedPose& before = work.positions[i == 0 ? 0 : i - 1];
    Move move;
    move.line = i + 1;
    move.has_start = i > 0;
    move.end = here.pose;
    move.tool = 0;
    move.set_feed({1000, FeedUnit::per_minute});
    work.path.moves.push_back(move);
    work.groups.push_back(group_of(before, here));
  }
}

}  // namespace

const char* group_name(MoveGroup group) {
  static constexpr std::array<const char*, 5> kNames = {"contact", "air", "gouge", "holder", "link"};
  return kNames[static_cast<std::size_t>(group)];
}

IndexedMesh make_bench_mesh(BenchPart part, std::size_t triangles) { return plan_of(part).mesh(triangles); }

Workload make_workload(const WorkloadKey& key, unsigned threads) {
  const PartPlan plan = plan_of(key.part);
  Workload work;
  work.tool = plan.tools[static_cast<std::size_t>(key.tool)];
  work.scene.parts = {plan.mesh(key.triangles)};
  const std::string file = cache_file(plan, work.tool, key);
  if (!read_positions(file, plan.positions * key.density, work.positions)) {
    work.positions = place_tool(plan, work.tool, ExactDistance(work.scene.parts[0]), key.density, threads);
    // A cache that cannot be written only costs time.
    if (!file.empty()) static_cast<void>(write_file(file, bytes_of(work.positions)));
  }
  add_moves(work);
  return work;
}

Toolpath only(const Workload& work, MoveGroup group) {
  Toolpath path = work.path;
  path.moves.clear();
  for (std::size_t i = 0; i < work.path.moves.size(); ++i) {
    if (work.groups[i] == group) path.moves.push_back(work.path.moves[i]);
  }
  return path;
}

}  // namespace gouge::bench

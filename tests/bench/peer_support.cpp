#include "tests/bench/peer_support.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "lib/base/parallel.h"
#include "tests/support/motions.h"

namespace gouge::bench {
namespace {

constexpr std::size_t kRun = 5;  // consecutive positions in a stretch of the sample
constexpr std::size_t kInstants = 64;
constexpr double kGouged_mm = -0.011;  // tolerance and resolution of the check
constexpr double kClear_mm = 0.002;    // what 64 instants may overlook, many times over
constexpr std::array<const char*, 3> kTools = {"ball", "bull", "taper"};

const char* part_name(BenchPart part) { return part == BenchPart::wavy ? "wavy" : "unseen"; }

std::vector<std::size_t> spread(std::size_t first, std::size_t last, std::size_t count) {
  const std::size_t total = last - first;
  std::vector<std::size_t> indices;
  if (count >= total) {
    for (std::size_t i = first; i < last; ++i) indices.push_back(i);
    return indices;
  }
  const std::size_t runs = std::max<std::size_t>(1, count / kRun);
  for (std::size_t run = 0; run < runs; ++run) {
    const std::size_t start = first + run * (total - kRun) / runs;
    for (std::size_t k = 0; k < kRun; ++k) indices.push_back(start + k);
  }
  return indices;
}

double closest(const BenchTool& tool, const ExactDistance& mesh, const Pose& pose) {
  const double lower = mesh.minimum(tool.lower, pose, 0.1, kTruthAccuracy_mm).distance_mm;
  return mesh.minimum(tool.holder, pose, lower, kTruthAccuracy_mm).distance_mm;
}

std::vector<Vec2> contour_of(const CompiledTool& tool, double chord_mm) {
  std::vector<Vec2> points;
  for (const BoundaryElement& e : tool.elements) {
    if (e.kind == ElementKind::vertex) continue;
    if (points.empty()) points.push_back(e.a);
    if (e.kind == ElementKind::arc) {
      const Vec2 from = e.a - e.center, to = e.b - e.center;
      const double turn = std::atan2(from.x() * to.y() - from.y() * to.x(), from.dot(to));
      const double step = 2 * std::acos(1 - chord_mm / e.radius_mm);
      const int count = static_cast<int>(std::ceil(std::abs(turn) / step));
      for (int k = 1; k < count; ++k) {
        points.push_back(e.center + Eigen::Rotation2Dd(turn * k / count) * from);
      }
    }
    points.push_back(e.b);
  }
  return points;
}

std::string label_of(BenchPart part, ToolKind tool, std::size_t size) {
  return std::string(part_name(part)) + "/" + kTools[static_cast<std::size_t>(tool)] + "/" + std::to_string(size);
}

std::shared_ptr<const PeerCase> current_case(BenchPart part, ToolKind tool, std::size_t size, std::size_t density) {
  static std::string kept_name;
  static std::shared_ptr<const PeerCase> kept;
  const std::string name = label_of(part, tool, size) + "x" + std::to_string(density);
  if (kept_name != name) {
    kept.reset();
    kept = std::make_shared<PeerCase>(PeerCase{part, tool, size, make_workload({part, tool, size, density})});
    kept_name = name;
  }
  return kept;
}

/// Result of `prepare` for this label, made once however often the benchmark library calls.
const std::function<void(benchmark::State&)>& prepared(const std::string& label, const Measurement& m, BenchPart part,
                                                       ToolKind tool, std::size_t size) {
  static std::string kept_label;
  static std::function<void(benchmark::State&)> kept;
  if (kept_label != label) {
    kept = nullptr;
    kept = m.prepare(current_case(part, tool, size, m.density));
    kept_label = label;
  }
  return kept;
}

bool is_asked(BenchPart part) {
  const char* text = std::getenv("GOUGE_BENCH_PARTS");
  return text == nullptr || std::string(text).find(part_name(part)) != std::string::npos;
}

std::vector<std::size_t> asked_sizes() {
  const char* text = std::getenv("GOUGE_BENCH_SIZES");
  if (text == nullptr) return {std::begin(kSizes), std::end(kSizes)};
  std::vector<std::size_t> sizes;
  for (char* at = nullptr; *text != '\0'; text = *at == ',' ? at + 1 : at) {
    sizes.push_back(std::strtoul(text, &at, 10));
    if (at == text) break;
  }
  return sizes;
}

}  // namespace

std::string PeerCase::label() const { return label_of(part, tool, triangles); }

std::vector<SampledPose> sample_poses(const PeerCase& c, std::size_t count) {
  std::vector<SampledPose> sample;
  for (const std::size_t i : spread(0, c.work.positions.size(), count)) {
    const PlacedPose& p = c.work.positions[i];
    sample.push_back({i, std::min(p.lower_mm, p.holder_mm)});
  }
  return sample;
}

std::vector<SampledMove> sample_moves(const PeerCase& c, std::size_t count) {
  std::vector<SampledMove> sample;
  for (const std::size_t i : spread(1, c.work.path.moves.size(), count)) {
    const Move& move = c.work.path.moves[i];
    sample.push_back({test::straight(c.work.path.start_of(i), move.end), i, c.work.groups[i], 0});
  }
  const ExactDistance mesh(c.work.scene.parts[0]);
  for_each_chunk(sample.size(), kRun, 0, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      double least = closest(c.work.tool, mesh, sample[i].motion.start());
      for (std::size_t k = 1; k <= kInstants; ++k) {
        const double t = static_cast<double>(k) / static_cast<double>(kInstants);
        least = std::min(least, closest(c.work.tool, mesh, sample[i].motion.at(t)));
      }
      sample[i].closest_mm = least;
    }
  });
  return sample;
}

void Wrongs::count(double closest_mm, bool is_hit) {
  ++asked_;
  if (closest_mm < kGouged_mm && !is_hit) {
    ++missed_;
    largest_missed_mm_ = std::max(largest_missed_mm_, -closest_mm);
  }
  if (closest_mm > kClear_mm && is_hit) ++invented_;
}

void Wrongs::count_depth(double closest_mm, double depth_mm) {
  count(closest_mm, depth_mm > 0);
  largest_depth_error_mm_ = std::max(largest_depth_error_mm_, std::abs(std::max(0.0, -closest_mm) - depth_mm));
}

void Wrongs::report(benchmark::State& state) const {
  state.counters["asked"] = static_cast<double>(asked_);
  state.counters["missed"] = static_cast<double>(missed_);
  state.counters["invented"] = static_cast<double>(invented_);
  state.counters["largest_missed_mm"] = largest_missed_mm_;
  state.counters["depth_error_mm"] = largest_depth_error_mm_;
}

Eigen::Matrix3d rotation_of(const Vec3& axis) {
  Eigen::Matrix3d m;
  const Vec3 u = axis.unitOrthogonal();
  m.col(0) = u;
  m.col(1) = axis.cross(u);
  m.col(2) = axis;
  return m;
}

IndexedMesh tessellate_tool(const BenchTool& tool, double chord_mm) {
  const std::vector<Vec2> contour = contour_of(tool.variants.bare, chord_mm);
  const double step = 2 * std::acos(1 - chord_mm / tool.variants.bare.r_max_mm);
  const auto sides = static_cast<Corner>(std::ceil(2 * std::numbers::pi / step));
  IndexedMesh mesh;
  mesh.name = tool.name;
  mesh.vertices.emplace_back(0, 0, contour.front().y());
  mesh.vertices.emplace_back(0, 0, contour.back().y());
  Corner rings = 0;
  for (const Vec2& p : contour) {
    if (p.x() < 1e-9) continue;
    for (Corner k = 0; k < sides; ++k) {
      const double turn = 2 * std::numbers::pi * k / sides;
      mesh.vertices.emplace_back(p.x() * std::cos(turn), p.x() * std::sin(turn), p.y());
    }
    ++rings;
  }
  const auto at = [sides](Corner ring, Corner k) { return 2 + ring * sides + k % sides; };
  for (Corner k = 0; k < sides; ++k) {
    mesh.triangles.push_back({0, at(0, k + 1), at(0, k)});
    mesh.triangles.push_back({1, at(rings - 1, k), at(rings - 1, k + 1)});
    for (Corner ring = 0; ring + 1 < rings; ++ring) {
      mesh.triangles.push_back({at(ring, k), at(ring, k + 1), at(ring + 1, k + 1)});
      mesh.triangles.push_back({at(ring, k), at(ring + 1, k + 1), at(ring + 1, k)});
    }
  }
  return mesh;
}

void register_measurements(std::vector<Measurement> measurements) {
  const auto all = std::make_shared<std::vector<Measurement>>(std::move(measurements));
  for (const BenchPart part : {BenchPart::wavy, BenchPart::unseen}) {
    if (!is_asked(part)) continue;
    for (const ToolKind tool : {ToolKind::ball, ToolKind::bull, ToolKind::taper}) {
      for (const std::size_t size : asked_sizes()) {
        for (const Measurement& m : *all) {
          if (size > m.largest || size < m.smallest || (!m.is_for_all_tools && tool != ToolKind::ball)) continue;
          const std::string label = m.name + "/" + label_of(part, tool, size);
          benchmark::RegisterBenchmark(label.c_str(), [all, label, &m, part, tool, size](benchmark::State& state) {
            prepared(label, m, part, tool, size)(state);
          })->Unit(benchmark::kMicrosecond);
        }
      }
    }
  }
}

void time_poses(benchmark::State& state, const PeerCase& c, const std::vector<SampledPose>& sample,
                const std::function<double(const Pose&)>& depth, bool is_yes_or_no) {
  std::vector<double> results(sample.size());
  for ([[maybe_unused]] auto _ : state) {
    for (std::size_t i = 0; i < sample.size(); ++i) {
      results[i] = depth(c.work.positions[sample[i].position].pose);
    }
  }
  Wrongs wrongs;
  for (std::size_t i = 0; i < sample.size(); ++i) {
    if (is_yes_or_no) {
      wrongs.count(sample[i].closest_mm, results[i] > 0);
    } else {
      wrongs.count_depth(sample[i].closest_mm, results[i]);
    }
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(sample.size()));
  wrongs.report(state);
}

void time_moves(benchmark::State& state, const std::vector<SampledMove>& sample,
                const std::function<bool(const Motion&)>& is_hit) {
  std::vector<char> results(sample.size());
  for ([[maybe_unused]] auto _ : state) {
    for (std::size_t i = 0; i < sample.size(); ++i) results[i] = is_hit(sample[i].motion) ? 1 : 0;
  }
  Wrongs wrongs;
  for (std::size_t i = 0; i < sample.size(); ++i) wrongs.count(sample[i].closest_mm, results[i] != 0);
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(sample.size()));
  wrongs.report(state);
}

int run_measurements(int count, char** words) {
  benchmark::Initialize(&count, words);
  if (benchmark::ReportUnrecognizedArguments(count, words)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}

bool is_quick() { return std::getenv("GOUGE_BENCH_QUICK") != nullptr; }

std::size_t scaled(std::size_t count) { return is_quick() ? std::max<std::size_t>(kRun, count / 4) : count; }

}  // namespace gouge::bench

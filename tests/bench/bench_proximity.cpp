#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

#include "lib/tool/evaluate.h"
#include "lib/tool/evaluate_batch.h"
#include "tests/support/scatter.h"
#include "toolmodels/compile_tool.h"

// The tool's BSP against a plain loop over all elements, for tools of 4, 8, 16 and 32 elements: at points
// without order (every branch a surprise) and at points along a curve, one at a time and 4096 at once.

namespace gouge {
namespace {

// A ball of diameter 10 with steps and cones above it; each adds a segment and a vertex.
CompiledTool tool_of(std::size_t elements) {
  const double radii[] = {16, 11, 20, 23, 15, 18, 25, 30};
  Profile profile;
  profile.elements.push_back(make_convex_arc(Body::cutter, {0, 0}, {5, 5}, {0, 5}, 5));
  Vec2 at(5, 5);
  const auto go_to = [&](const Vec2& to) {
    profile.elements.push_back(make_segment(Body::cutter, at, to));
    at = to;
  };
  go_to({5, 30});
  for (std::size_t k = 0; 2 * k + 4 < elements; ++k)
    go_to(k % 2 == 0 ? Vec2(radii[k / 2 % 8], at.y() + (k % 4 == 0 ? 0 : 3))
                     : Vec2(at.x() + (k % 4 == 1 ? 0 : 2), at.y() + 12));
  go_to({0, at.y()});
  return compile_tool("stepped", profile);
}

struct Points {
  std::vector<double> r, z, distances;

  Points(const CompiledTool& tool, bool is_ordered) : distances(4096) {
    test::Scatter random(5);
    for (std::size_t i = 0; i < distances.size(); ++i) {
      const double angle = 1e-3 * static_cast<double>(i);
      r.push_back(is_ordered ? std::abs(20 * std::sin(angle)) : random.in(0, 1.3 * tool.r_max_mm));
      z.push_back(is_ordered ? 0.5 * tool.z_max_mm * (1 + std::cos(0.77 * angle)) : random.in(-10, tool.z_max_mm + 10));
    }
  }
};

using Batch = void (*)(const CompiledTool&, std::span<const double>, std::span<const double>, std::span<double>);

void measure(benchmark::State& state, Batch batch, std::size_t at_once) {
  const CompiledTool tool = tool_of(static_cast<std::size_t>(state.range(0)));
  if (tool.elements.size() != static_cast<std::size_t>(state.range(0))) {
    state.SkipWithError("the tool has another number of elements");
    return;
  }
  Points points(tool, state.range(1) != 0);
  const std::size_t all = points.r.size();
  for (auto _ : state) {
    for (std::size_t i = 0; i < all; i += at_once)
      batch(tool, {&points.r[i], at_once}, {&points.z[i], at_once}, {&points.distances[i], at_once});
    benchmark::DoNotOptimize(points.distances.data());
    benchmark::ClobberMemory();
  }
  const auto done = static_cast<double>(state.iterations()) * static_cast<double>(all);
  state.counters["per_point"] = benchmark::Counter(done, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void arguments(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgNames({"elements", "ordered"})->ArgsProduct({{4, 8, 16, 32}, {0, 1}});
}

BENCHMARK_CAPTURE(measure, tree_one, signed_distances_by_tree, 1)->Apply(arguments);
BENCHMARK_CAPTURE(measure, loop_one, signed_distances_by_loop, 1)->Apply(arguments);
BENCHMARK_CAPTURE(measure, tree_many, signed_distances_by_tree, 4096)->Apply(arguments);
BENCHMARK_CAPTURE(measure, loop_many, signed_distances_by_loop, 4096)->Apply(arguments);
BENCHMARK_CAPTURE(measure, loop_sixteen, signed_distances_by_loop, 16)->Apply(arguments);
BENCHMARK_CAPTURE(measure, tree_sixteen, signed_distances_by_tree, 16)->Apply(arguments);

}  // namespace
}  // namespace gouge

BENCHMARK_MAIN();

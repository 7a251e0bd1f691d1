#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "tests/bench/verdict_hash.h"
#include "tests/bench/workload.h"

// Times check_path over the generated work, for tuning: one line for each tool, size and group of moves.
//
//   bench_engine [--tool ball|bull|taper|all] [--size N|all] [--moves all|contact|air|gouge|holder|link|each]
//                [--threads 1[,2...]] [--repeat 3] [--density 1|10] [--part wavy|unseen]

namespace gouge::bench {
namespace {

struct Arguments {
  std::vector<ToolKind> tools = {ToolKind::ball, ToolKind::bull, ToolKind::taper};
  std::vector<std::size_t> sizes = {std::begin(kSizes), std::end(kSizes)};
  std::string moves = "all";
  std::vector<unsigned> threads = {1, 2};
  int repeat = 3;
  std::size_t density = 1;
  BenchPart part = BenchPart::wavy;
};

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void time_path(const std::string& label, const Toolpath& path, const Workload& work, const PreparedScene& scene,
               unsigned threads, int repeat) {
  if (path.moves.empty()) return;
  CheckOptions options;
  options.threads = threads;
  std::vector<double> times;
  CheckResult result;
  for (int k = 0; k < repeat; ++k) {
    const auto start = std::chrono::steady_clock::now();
    result = check_path(path, {&work.tool.variants}, scene, options);
    summarise(path, result);
    times.push_back(seconds_since(start));
  }
  std::sort(times.begin(), times.end());
  const double moves = static_cast<double>(path.moves.size());
  const double median = times[times.size() / 2];
  const StateCounts& n = result.counts;
  std::printf("%s %2u %8zu %10.0f %9.3f %9.3f %8.1f  %zu/%zu/%zu/%zu/%zu %8.4f %016llx\n", label.c_str(), threads,
              path.moves.size(), moves / median, 1e6 * median / moves, 1e6 * times.front() / moves,
              static_cast<double>(result.evaluations) / moves, n.clean, n.near_miss, n.gouge, n.buried, n.not_certified,
              result.worst_depth_mm, static_cast<unsigned long long>(VerdictHash(result).value()));
  std::fflush(stdout);
}

void time_workload(const Arguments& arguments, ToolKind tool, std::size_t size) {
  const Workload work = make_workload({arguments.part, tool, size, arguments.density});
  const auto start = std::chrono::steady_clock::now();
  const PreparedScene scene = prepare_scene(work.scene);
  std::printf("# %s, %zu triangles: tree built in %.3f s\n", work.tool.name.c_str(),
              work.scene.parts[0].triangles.size(), seconds_since(start));
  static constexpr MoveGroup kGroups[] = {MoveGroup::contact, MoveGroup::air, MoveGroup::gouge, MoveGroup::holder,
                                          MoveGroup::link};
  for (const unsigned threads : arguments.threads) {
    const auto label = [&](const char* group) {
      char text[64];
      std::snprintf(text, sizeof text, "%-6s %8zu %-8s", work.tool.name.c_str(), size, group);
      return std::string(text);
    };
    if (arguments.moves == "all" || arguments.moves == "each")
      time_path(label("all"), work.path, work, scene, threads, arguments.repeat);
    for (const MoveGroup group : kGroups) {
      if (arguments.moves != group_name(group) && arguments.moves != "each") continue;
      time_path(label(group_name(group)), only(work, group), work, scene, threads, arguments.repeat);
    }
  }
}

std::vector<ToolKind> tools_of(std::string_view word) {
  if (word == "ball") return {ToolKind::ball};
  if (word == "bull") return {ToolKind::bull};
  if (word == "taper") return {ToolKind::taper};
  return {ToolKind::ball, ToolKind::bull, ToolKind::taper};
}

Arguments parse(int count, char** words) {
  Arguments arguments;
  for (int k = 1; k + 1 < count; k += 2) {
    const std::string_view name = words[k], value = words[k + 1];
    if (name == "--tool") arguments.tools = tools_of(value);
    if (name == "--size" && value != "all") arguments.sizes = {std::strtoul(words[k + 1], nullptr, 10)};
    if (name == "--moves") arguments.moves = value;
    if (name == "--repeat") arguments.repeat = std::max(1, std::atoi(words[k + 1]));
    if (name == "--density") arguments.density = std::strtoul(words[k + 1], nullptr, 10);
    if (name == "--part") arguments.part = value == "unseen" ? BenchPart::unseen : BenchPart::wavy;
    if (name != "--threads") continue;
    arguments.threads.clear();
    for (char* at = words[k + 1]; *at != '\0'; at += *at == ',') {
      arguments.threads.push_back(static_cast<unsigned>(std::strtoul(at, &at, 10)));
    }
  }
  return arguments;
}

}  // namespace
}  // namespace gouge::bench

int main(int count, char** words) {
  const gouge::bench::Arguments arguments = gouge::bench::parse(count, words);
  std::printf(
      "# tool      size moves     thr    count    moves/s  us/move  us(best)  evals/m  "
      "clean/near/gouge/buried/uncertified  worst hash\n");
  for (const gouge::bench::ToolKind tool : arguments.tools) {
    for (const std::size_t size : arguments.sizes) gouge::bench::time_workload(arguments, tool, size);
  }
  return 0;
}

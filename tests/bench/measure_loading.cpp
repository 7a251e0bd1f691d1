#include <benchmark/benchmark.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "lib/base/files.h"
#include "lib/mesh/load_mesh.h"
#include "lib/mesh/mesh_builder.h"
#include "lib/mesh/read_stl.h"
#include "lib/mesh/write_stl.h"
#include "postproc/formats/read_toolpath.h"
#include "tests/bench/peer_support.h"

// From files to what the check needs: a large STL file to a welded mesh and its tree, the memory that takes,
// and a toolpath file to moves.

namespace gouge::bench {
namespace {

constexpr std::size_t kTriangles = 2000000;
constexpr std::size_t kCopies = 10;  // of the path's 20,000 positions in the toolpath file

std::string bench_file(const std::string& name) {
  const char* folder = std::getenv("GOUGE_BENCH_CACHE");
  return (folder != nullptr ? std::string(folder) : std::filesystem::temp_directory_path().string()) + "/" + name;
}

/// Runs `work` in a child process, so that neither its memory nor its threads stay with us.
template <class Work>
void in_child(const Work& work) {
  const pid_t child = fork();
  if (child == 0) _exit(work() ? 0 : 1);
  int status = 0;
  if (child < 0 || waitpid(child, &status, 0) != child || status != 0) std::abort();
}

std::string stl_file() {
  const std::string file = bench_file("wavy_2000000.stl");
  if (!std::filesystem::exists(file)) {
    in_child([&file] {
      const IndexedMesh mesh = make_bench_mesh(BenchPart::wavy, kTriangles);
      return write_file(file, binary_stl_bytes(mesh, LengthUnit::mm)).has_value();
    });
  }
  return file;
}

std::string toolpath_text() {
  const Workload work = make_workload({BenchPart::wavy, ToolKind::ball, 2400, 1});
  std::string text = "PARTNO/BENCH\nUNITS/MM\nMULTAX/ON\nLOADTL/1\nFEDRAT/1000.,MMPM\n";
  for (std::size_t copy = 0; copy < kCopies; ++copy) {
    for (const PlacedPose& p : work.positions) {
      char line[160];
      const Vec3 &t = p.pose.tip, &a = p.pose.axis;
      std::snprintf(line, sizeof line, "GOTO/%.6f,%.6f,%.6f,%.9f,%.9f,%.9f\n", t.x(), t.y(), t.z(), a.x(), a.y(),
                    a.z());
      text += line;
    }
  }
  return text + "FINI\n";
}

/// A field of /proc/self/status in kB.
double status_kb(const std::string& field) {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    double value = 0;
    if (word == field + ":" && status >> value) return value;
  }
  return 0;
}

/// Loads, welds and builds; what the check keeps stays alive until the end of the call.
void load_all(const std::string& file) {
  Scene scene;
  Result<LoadedMesh> loaded = load_mesh(file);
  if (!loaded) std::abort();
  scene.parts.push_back(std::move(loaded.value().mesh));
  const PreparedScene prepared = prepare_scene(scene);
  benchmark::DoNotOptimize(&prepared);
}

/// Peak of the resident memory, beyond what a fresh process has, of a child that does nothing but load.
void measure_peak(benchmark::State& state) {
  const std::string file = stl_file();
  double peak_kb = 0;
  for ([[maybe_unused]] auto _ : state) {
    int ends[2];
    if (pipe(ends) != 0) std::abort();
    in_child([&file, &ends] {
      std::ofstream("/proc/self/clear_refs") << "5";
      const double before_kb = status_kb("VmRSS");
      load_all(file);
      const double beyond_kb = status_kb("VmHWM") - before_kb;
      return write(ends[1], &beyond_kb, sizeof beyond_kb) == sizeof beyond_kb;
    });
    if (read(ends[0], &peak_kb, sizeof peak_kb) != sizeof peak_kb) std::abort();
    close(ends[0]);
    close(ends[1]);
  }
  state.counters["bytes_per_triangle"] = 1024 * peak_kb / static_cast<double>(kTriangles);
}

void measure_load(benchmark::State& state) {
  const std::string file = stl_file();
  for ([[maybe_unused]] auto _ : state) load_all(file);
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kTriangles));
}

void measure_weld(benchmark::State& state) {
  const std::string file = stl_file();
  for ([[maybe_unused]] auto _ : state) {
    const FileView view = view_file(file).value();
    const auto mesh = build_mesh(parse_stl(view.bytes, file, view.keep).value());
    benchmark::DoNotOptimize(&mesh);
  }
}

void measure_tree(benchmark::State& state) {
  Scene scene;
  scene.parts = {make_bench_mesh(BenchPart::wavy, kTriangles)};
  for ([[maybe_unused]] auto _ : state) {
    const PreparedScene prepared = prepare_scene(scene);
    benchmark::DoNotOptimize(&prepared);
  }
}

void measure_parse(benchmark::State& state) {
  const std::string text = toolpath_text();
  std::size_t moves = 0;
  for ([[maybe_unused]] auto _ : state) {
    const ReadOutcome outcome = read_toolpath("bench.apt", text);
    if (!outcome.toolpath) std::abort();
    moves = outcome.toolpath->moves.size();
  }
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(text.size()));
  state.counters["moves"] = static_cast<double>(moves);
}

}  // namespace
}  // namespace gouge::bench

int main(int count, char** words) {
  using namespace gouge::bench;
  // The peak first: its child must not inherit memory or threads of the others.
  benchmark::RegisterBenchmark("loading.peak", measure_peak)->Iterations(1);
  const std::vector<std::pair<const char*, void (*)(benchmark::State&)>> measurements = {
      {"loading.all", measure_load},
      {"loading.read_and_weld", measure_weld},
      {"loading.tree", measure_tree},
      {"loading.parse", measure_parse}};
  for (const auto& [name, one] : measurements) {
    benchmark::RegisterBenchmark(name, one)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();
  }
  return run_measurements(count, words);
}

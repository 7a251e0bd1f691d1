#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "postproc/gcode/reading/read_gcode.h"
#include "tests/bench/peer_support.h"

// From programs of each control to moves: plain feeds, one in a block, on one thread.

namespace gouge::bench {
namespace {

constexpr int kBlocks = 500000;

struct Control {
  const char* id;
  const char* begin;
  const char* block;  ///< a format of the number of the block, X, Y and Z
  const char* end;
};

constexpr Control kControls[] = {
    {"linuxcnc", "G17 G21 G40 G49 G54 G61 G80 G90 G94\nG0 X0. Y0. Z50.\nF1000.\n", "N%d G1 X%.4f Y%.4f Z%.4f\n",
     "M2\n"},
    {"haas", "%\nO1000\nG17 G21 G40 G49 G54 G80 G90 G94\nG0 X0. Y0. Z50.\nF1000.\n", "N%d G1 X%.4f Y%.4f Z%.4f\n",
     "M30\n%\n"},
    {"fanuc", "%\nO1000\nG17 G21 G40 G49 G54 G80 G90 G94\nG0 X0. Y0. Z50.\nF1000.\n", "N%d G1 X%.4f Y%.4f Z%.4f\n",
     "M30\n%\n"},
    {"siemens", "G17 G71 G90 G60 G54 G94 D1\nG0 X0 Y0 Z50\nF1000\n", "N%d G1 X%.4f Y%.4f Z%.4f\n", "M30\n"},
    {"heidenhain", "0 BEGIN PGM A MM\n1 TOOL CALL 1 Z S1000\n2 L X+0 Y+0 Z+50 R0 FMAX\n",
     "%d L X%+.4f Y%+.4f Z%+.4f F1000\n", "9999999 L Z+50 R0 FMAX M30\n9999999 END PGM A MM\n"}};

std::string program_of(const Control& control) {
  std::string text = control.begin;
  for (int i = 0; i < kBlocks; ++i) {
    char line[96];
    std::snprintf(line, sizeof line, control.block, i + 3, 0.01 * (i % 9973), 0.013 * (i % 7919), -0.001 * (i % 997));
    text += line;
  }
  return text + control.end;
}

GcodeOptions options_of(const Control& control) {
  GcodeOptions options;
  options.setup.control = control.id;
  options.setup.offsets["G54"] = WorkOffset{};
  options.setup.tool_length_mm = 100;
  return options;
}

void measure_reading(benchmark::State& state, const Control& control) {
  const std::string text = program_of(control);
  const GcodeOptions options = options_of(control);
  std::size_t moves = 0, checked = 0;
  for ([[maybe_unused]] auto _ : state) {
    const ReadOutcome outcome = read_gcode("program", SourceText(text), options, {});
    if (!outcome.toolpath) std::abort();
    moves = outcome.toolpath->moves.size();
    const auto is_checked = [](const Move& move) { return move.not_checked_reason.empty(); };
    checked = static_cast<std::size_t>(std::ranges::count_if(outcome.toolpath->moves, is_checked));
  }
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(text.size()));
  state.counters["moves"] = static_cast<double>(moves);
  state.counters["checked"] = static_cast<double>(checked);
}

}  // namespace
}  // namespace gouge::bench

int main(int count, char** words) {
  using namespace gouge::bench;
  for (const Control& control : kControls) {
    benchmark::RegisterBenchmark((std::string("reading.") + control.id).c_str(),
                                 [&control](benchmark::State& state) { measure_reading(state, control); })
        ->Unit(benchmark::kMillisecond)
        ->MeasureProcessCPUTime();
  }
  return run_measurements(count, words);
}

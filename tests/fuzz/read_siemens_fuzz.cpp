#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "lib/machine/read_machine.h"
#include "postproc/gcode/reading/read_gcode.h"
#include "tests/fuzz/require.h"

// A program of a Siemens control: what was read is sound, and nothing after a word that is not understood is checked.

namespace gouge {
namespace {

using fuzz::require;

constexpr const char* kMachine = R"({"name": "table", "joints": [
  {"name": "C", "type": "rotary", "side": "table", "direction": [0, 0, 1], "point": [0, 0, -50], "continuous": true},
  {"name": "B", "type": "rotary", "side": "table", "direction": [0, 1, 0], "point": [0, 0, -50], "min": -110, "max": 110},
  {"name": "X", "type": "linear", "side": "head", "direction": [1, 0, 0]},
  {"name": "Y", "type": "linear", "side": "head", "direction": [0, 1, 0]},
  {"name": "Z", "type": "linear", "side": "head", "direction": [0, 0, 1]}]})";

// The first byte chooses what the user states.
ProgramSetup fuzz_setup(std::uint8_t choice) {
  static const auto machine = std::make_shared<const Machine>(read_machine("table", kMachine).value());
  ProgramSetup setup;
  setup.control = "siemens";
  if ((choice & 1U) != 0) setup.machine = machine;
  if ((choice & 2U) != 0) setup.offsets["G54"] = WorkOffset{};
  if ((choice & 4U) != 0) setup.tool_length_mm = 100;
  if ((choice & 8U) != 0) setup.tip_tolerance_mm = 0.1;
  if ((choice & 16U) != 0) setup.start = "G17 G71 G90 G60 G54\nTRAFOOF\nG1\n";
  if ((choice & 32U) != 0) setup.winds_as_programmed = true;
  if ((choice & 64U) != 0) setup.is_block_delete_on = false;
  return setup;
}

void require_sound(const Toolpath& path) {
  require(!path.moves.empty() && !path.moves.front().has_start);
  bool is_lost = false;
  for (const Move& move : path.moves) {
    require(move.end.tip.allFinite() && move.end.axis.allFinite());
    require(move.statement < path.statements.size());
    require(move.tool == kNone || move.tool < path.tools.size());
    require(move.operation == kNone || move.operation < path.operations.size());
    const std::string reason(move.not_checked_reason);
    is_lost = is_lost || reason.find("is not understood:") != std::string::npos;
    require(!is_lost || !reason.empty());
    if (move.curve_kind != CurveKind::arc) continue;
    const PathArc& arc = path.arcs.at(move.curve);
    require(arc.center.allFinite() && arc.axis.allFinite() && arc.sweep_rad > 0);
  }
  require(path.joints == nullptr || path.joints->end.size() == path.moves.size());
}

}  // namespace
}  // namespace gouge

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string text(reinterpret_cast<const char*>(data + 1), size - 1);
  const gouge::ReadOutcome outcome =
      gouge::read_gcode("fuzz", gouge::SourceText(text), {gouge::fuzz_setup(data[0]), {}, {}, ""}, {});
  gouge::fuzz::require(outcome.toolpath.has_value() == outcome.errors.empty());
  if (outcome.toolpath) gouge::require_sound(*outcome.toolpath);
  return 0;
}

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "lib/machine/read_machine.h"
#include "postproc/gcode/heidenhain/tool_table.h"
#include "postproc/gcode/reading/read_gcode.h"
#include "tests/fuzz/require.h"

// A program of the control GOUGE_FUZZ_CONTROL, and the same text as a tool table of Heidenhain. What is read is sound.
// Where the reader loses the state of the control for good, no later move is checked.

namespace gouge {
namespace {

using fuzz::require;

constexpr const char* kMachine = R"({"name": "table", "joints": [
  {"name": "C", "type": "rotary", "side": "table", "direction": [0, 0, 1], "point": [0, 0, -50], "continuous": true},
  {"name": "B", "type": "rotary", "side": "table", "direction": [0, 1, 0], "point": [0, 0, -50], "min": -110, "max": 110},
  {"name": "X", "type": "linear", "side": "head", "direction": [1, 0, 0]},
  {"name": "Y", "type": "linear", "side": "head", "direction": [0, 1, 0]},
  {"name": "Z", "type": "linear", "side": "head", "direction": [0, 0, 1]}]})";

const std::string kControl = GOUGE_FUZZ_CONTROL;

std::string usual_start() {
  if (kControl == "siemens") return "G17 G71 G90 G60 G54\nTRAFOOF\nG1\n";
  if (kControl == "heidenhain") return "M129\nM127\nM137\n";
  return "G17 G21 G90 G94 G40 G49 G80 G54 G98\n";
}

// The first byte chooses what the user states. A call of a program beside the file finds a text that begins in this one.
ProgramSetup fuzz_setup(std::uint8_t choice, const std::string& text) {
  static const auto machine = std::make_shared<const Machine>(read_machine("table", kMachine).value());
  ProgramSetup setup;
  setup.control = kControl;
  if ((choice & 1U) != 0) setup.machine = machine;
  if ((choice & 2U) != 0) setup.offsets["G54"] = WorkOffset{};
  if ((choice & 4U) != 0) setup.tool_length_mm = 100;
  if ((choice & 8U) != 0) setup.tip_tolerance_mm = 0.1;
  if ((choice & 16U) != 0) setup.start = usual_start();
  if ((choice & 32U) != 0) setup.winds_as_programmed = true;
  if ((choice & 64U) != 0) setup.is_block_delete_on = false;
  if ((choice & 128U) != 0) {
    setup.home_mm = Vec3::Zero();
    setup.plain_numbers = PlainNumbers::units;
    setup.tip_frame = TipFrame::table;
    if ((choice & 16U) == 0) setup.start = text.substr(0, text.size() % 64);
    setup.read_beside = [text](const std::string&) { return std::vector{text.substr(text.size() / 2)}; };
  }
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
    is_lost = is_lost || (kControl == "siemens" && reason.find("is not understood:") != std::string::npos);
    require(!is_lost || !reason.empty());
    if (move.curve_kind != CurveKind::arc) continue;
    const PathArc& arc = path.arcs.at(move.curve);
    require(arc.center.allFinite() && arc.axis.allFinite() && std::isfinite(arc.sweep_rad) && arc.sweep_rad > 0);
  }
  require(path.joints == nullptr || path.joints->end.size() == path.moves.size());
}

}  // namespace
}  // namespace gouge

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string text(reinterpret_cast<const char*>(data + 1), size - 1);
  const gouge::ReadOutcome outcome =
      gouge::read_gcode("fuzz", gouge::SourceText(text), {gouge::fuzz_setup(data[0], text), {}, {}, ""}, {});
  gouge::fuzz::require(outcome.toolpath.has_value() == outcome.errors.empty());
  if (outcome.toolpath) gouge::require_sound(*outcome.toolpath);
  static_cast<void>(gouge::read_heidenhain_tool_table("tool.t", text));
  return 0;
}

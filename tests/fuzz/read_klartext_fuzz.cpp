#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "lib/machine/read_machine.h"
#include "postproc/gcode/heidenhain/tool_table.h"
#include "postproc/gcode/reading/read_gcode.h"
#include "tests/fuzz/require.h"

// Programs in Klartext, without a machine and with one. The same blocks are read as the blocks at the start and as a
// tool table. What was read is sound.

namespace gouge {
namespace {

using fuzz::require;

std::shared_ptr<const Machine> machine() {
  static const Result<Machine> read = read_machine("preset", find_preset("table-b-head")->text);
  return std::make_shared<const Machine>(*read);
}

void require_sound(const std::string& text, bool has_machine) {
  GcodeOptions options;
  options.setup.control = "heidenhain";
  options.setup.start = text.substr(0, text.size() % 64);
  if (has_machine) options.setup.machine = machine();
  const ReadOutcome outcome = read_gcode("fuzz.h", text, options, {});
  require(outcome.toolpath.has_value() != !outcome.errors.empty());
  if (!outcome.toolpath) return;
  const Toolpath& path = *outcome.toolpath;
  for (const Move& move : path.moves) {
    require(move.end.tip.allFinite() && move.end.axis.allFinite());
    require(move.statement < path.statements.size() && (move.tool == kNone || move.tool < path.tools.size()));
    if (move.curve_kind == CurveKind::arc) require(std::isfinite(path.arcs.at(move.curve).sweep_rad));
  }
  require(!path.joints || path.joints->end.size() == path.moves.size());
}

}  // namespace
}  // namespace gouge

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  gouge::require_sound(text, false);
  gouge::require_sound(text, true);
  static_cast<void>(gouge::read_heidenhain_tool_table("tool.t", text));
  return 0;
}

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "lib/path/chords.h"
#include "lib/path/path_info.h"
#include "postproc/formats/read_toolpath.h"
#include "postproc/formats/write_corrected.h"
#include "postproc/formats/write_toolpath.h"
#include "tests/fuzz/require.h"

// One target for each reader: GOUGE_FUZZ_DIALECT names it, "" lets the content decide. What was read is sound,
// keeps its bytes when nothing changes, takes a correction or refuses it, and can be written anew in any dialect or is
// refused with an error.

namespace gouge {
namespace {

using fuzz::require;

constexpr double kCoarse_mm = 0.5;

ReadOptions fuzz_options() {
  ReadOptions options;
  options.dialect = dialect_called(GOUGE_FUZZ_DIALECT);
  return options;
}

void require_curve(const Toolpath& path, const Move& move) {
  if (move.curve_kind == CurveKind::arc) {
    const PathArc& arc = path.arcs.at(move.curve);
    require(arc.center.allFinite() && arc.axis.allFinite() && std::isfinite(arc.sweep_rad));
  }
  if (move.curve_kind != CurveKind::spline) return;
  const PathSpline& spline = path.splines.at(move.curve);
  require(!spline.pieces.empty());
  for (const SplinePiece& piece : spline.pieces) {
    require(piece.u0 < piece.u1);
    for (const Vec3& point : piece.control) require(point.allFinite());
  }
}

void require_sound(const Toolpath& path) {
  require(!path.moves.empty() && !path.moves.front().has_start);
  for (const Move& move : path.moves) {
    require(move.end.tip.allFinite() && move.end.axis.allFinite());
    require(move.statement < path.statements.size());
    require(move.tool == kNone || move.tool < path.tools.size());
    require(move.operation == kNone || move.operation < path.operations.size());
    require_curve(path, move);
  }
  const PathInfo info = describe_path(path);
  require(info.alone > 0 && info.alone <= path.moves.size());
}

// Lines that are lifted, with their starts put in before them, and curves as chords, some of them.
std::vector<PathChange> some_changes(const Toolpath& path, std::size_t seed) {
  std::vector<PathChange> changes;
  for (std::size_t i = 0; i < path.moves.size(); i += 1 + seed % 3) {
    const Move& move = path.moves[i];
    if (!move.not_checked_reason.empty() || move.kind == MoveKind::cycle) continue;
    if (move.curve_kind != CurveKind::none) {
      if (!move.has_start || seed % 5 == 0) continue;
      std::vector<Pose> chords = chords_of(path, i, kCoarse_mm);
      require(!chords.empty());
      chords.pop_back();
      changes.push_back({i, std::nullopt, std::move(chords), true});
      continue;
    }
    Pose end = move.end;
    end.tip += 1.25 * end.axis;
    changes.push_back({i, end, {}, {}});
    if (move.has_start) changes.back().inserted_before.push_back(path.start_of(i));
  }
  return changes;
}

void read_and_write(const std::string& bytes) {
  const ReadOutcome outcome = read_toolpath("fuzz", bytes, fuzz_options());
  require(outcome.toolpath.has_value() == outcome.errors.empty());
  if (!outcome.toolpath) return;
  const Toolpath& path = *outcome.toolpath;
  require_sound(path);
  const Result<std::string> same = write_corrected(path, {});
  require(same.has_value() && *same == bytes);
  const Result<std::string> lifted = write_corrected(path, some_changes(path, bytes.size()));
  require(lifted.has_value() || !lifted.error().code.empty());
  if (lifted) {
    const ReadOutcome again = read_toolpath("again", *lifted, fuzz_options());
    if (again.toolpath) require_sound(*again.toolpath);
  }
  const std::span<const Dialect> dialects = all_dialects();
  const Result<WrittenToolpath> written = write_toolpath(path, dialects[bytes.size() % dialects.size()]);
  require(written.has_value() || !written.error().code.empty());
}

}  // namespace
}  // namespace gouge

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  gouge::read_and_write(std::string(reinterpret_cast<const char*>(data), size));
  return 0;
}

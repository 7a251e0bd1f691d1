#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "postproc/cldata/read_toolpath.h"
#include "postproc/cldata/write_corrected.h"
#include "postproc/cldata/write_toolpath.h"

// One target for each reader: GOUGE_FUZZ_DIALECT names it, "" lets the content tell. What was read is sound,
// keeps its bytes when nothing changes, and can be written anew or is refused with an error.

namespace gouge {
namespace {

void require(bool condition) {
  if (!condition) std::abort();
}

void read_and_write(const std::string& bytes) {
  ReadOptions options;
  options.dialect = dialect_called(GOUGE_FUZZ_DIALECT);
  const ReadOutcome outcome = read_toolpath("fuzz", bytes, options);
  require(outcome.toolpath.has_value() == outcome.errors.empty());
  if (!outcome.toolpath) return;
  const Toolpath& path = *outcome.toolpath;
  for (const Move& move : path.moves) {
    require(move.end.tip.allFinite() && move.end.axis.allFinite());
    require(move.statement < path.statements.size());
    require(move.tool == kNone || move.tool < path.tools.size());
    require(move.operation == kNone || move.operation < path.operations.size());
  }
  const Result<std::string> same = write_corrected(path, {});
  require(same.has_value() && *same == bytes);
  std::vector<PathChange> changes;
  for (std::size_t i = 0; i < path.moves.size(); i += 1 + bytes.size() % 3) {
    const Move& move = path.moves[i];
    if (!move.not_checked_reason.empty() || move.curve_kind != CurveKind::none ||
        move.kind == MoveKind::cycle)
      continue;
    Pose end = move.end;
    end.tip += 1.25 * end.axis;
    changes.push_back({i, end, {}, {}});
    if (move.has_start) changes.back().inserted_before.push_back(path.start_of(i));
  }
  const Result<std::string> lifted = write_corrected(path, changes);
  require(lifted.has_value() || !lifted.error().code.empty());
  const DialectKind kind = bytes.size() % 2 == 0 ? DialectKind::nx_clsf : DialectKind::catia;
  const Result<WrittenToolpath> written = write_toolpath(path, dialect_of(kind));
  require(written.has_value() || !written.error().code.empty());
}

}  // namespace
}  // namespace gouge

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  gouge::read_and_write(std::string(reinterpret_cast<const char*>(data), size));
  return 0;
}

#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/result.h"
#include "lib/base/units.h"
#include "lib/check/verdict.h"
#include "lib/geom/vec.h"

// A result as `--json` has written it (docs/formats/report_json.md), read again. Lengths are in mm.

namespace gouge {

/// Keys of `options.more` that name the law of motion.
inline constexpr std::array<const char*, 3> kLawOptions = {"machine", "feed-law", "rapid-law"};

struct StoredWitness {
  double t = 0;
  Vec3 point = Vec3::Zero();
  std::string body, against, mesh;
};

/// A move that is not clean.
struct StoredMove {
  std::size_t move = 0, line = 0;
  MoveState state = MoveState::gouge;
  std::string kind, tool, operation, statement;
  std::string motion;                                  ///< motion_key
  std::optional<double> depth_mm, depth_upper_mm;      ///< none: not measured, or no bound was reached
  std::optional<double> overcut_mm, overcut_upper_mm;  ///< none: not measured
  std::optional<StoredWitness> witness;
  std::string reason;
};

struct StoredFinding {
  std::size_t number = 0;  ///< finding_numbers
  MoveState state = MoveState::gouge;
  std::size_t first_move = 0, last_move = 0, worst_move = 0;
  std::size_t line = 0;
  std::string tool, body, against;
  std::optional<std::size_t> tool_index;  ///< into StoredResult::tools; none: no tool
};

struct StoredTool {
  std::string key, identity;  ///< as tool_key and ToolFacts::identity
  std::vector<std::string> bodies;
};

/// Moves of one operation and tool, up to the next run.
struct StoredRun {
  std::size_t first_move = 0;
  std::string operation, tool;
};

struct StoredInput {
  std::string role, name, checksum;
};

/// Options of the check that affect which gouges there are.
struct StoredOptions {
  double tolerance_mm = 0, resolution_mm = 0, stock_to_leave_mm = 0, shank_clearance_mm = 0, holder_clearance_mm = 0;
  std::string rapid;
  std::vector<std::string> limits{};  ///< of single files, as typed: "vise.stl,clearance=1"; sorted
  /// The law of motion: "machine=preset:NAME", "feed-law=axis", the checksum of a machine file; sorted. Empty: the
  /// great circle.
  std::vector<std::string> law{};

  bool operator==(const StoredOptions&) const = default;
};

struct StoredResult {
  std::string file;     ///< that was read
  std::string version;  ///< of the program that wrote it
  std::string verdict;
  LengthUnit unit = LengthUnit::mm;
  std::string toolpath;  ///< as it was named then
  std::string placement;
  StoredOptions options;
  std::vector<StoredInput> inputs;
  std::vector<StoredTool> tools;
  std::vector<StoredFinding> findings;  ///< gouges and buried tools, in the order of the path
  std::vector<StoredMove> moves;        ///< those that are not clean, in the order of the path
  std::vector<std::string> motions;     ///< of every move the first kListedDigits of its motion_key
  std::vector<StoredRun> runs;          ///< of all moves
  std::size_t left_out_as_asked = 0;    ///< rapids

  /// Returns none where that move is clean.
  [[nodiscard]] const StoredMove* find_move(std::size_t move) const;
  /// Returns the moves of a finding, in order: those of its interval and state.
  [[nodiscard]] std::vector<const StoredMove*> moves_of(const StoredFinding& finding) const;
  [[nodiscard]] const StoredMove& worst_of(const StoredFinding& finding) const {
    return *find_move(finding.worst_move);
  }
  /// Requires a move of the path.
  [[nodiscard]] const StoredRun& run_of(std::size_t move) const;
  /// Returns how many of the moves [first, end) are of the operation and tool of `run`.
  [[nodiscard]] std::size_t moves_like(const StoredRun& run, std::size_t first, std::size_t end) const;
  /// Returns the checksums of the files of a role, in order, a line each.
  [[nodiscard]] std::string contents_of(std::string_view role) const;
};

/// Returns "T1", a quoted name, or "the unnamed tool", by its key.
[[nodiscard]] std::string stored_tool_label(const std::string& key);
/// Returns a finding without its location, in the unit of its result: "0.213 mm cutter T1 at (12.3, 4.5, 6.7), move
/// 118".
[[nodiscard]] std::string stored_finding_text(const StoredResult& result, const StoredFinding& finding);

/// Reads the bytes of `file`.
/// Errors, with the line: result-syntax, result-duplicate-key, json-too-deep, json-too-long. (1) result-format: not a
/// result of this program, or of an older version that lacks needed fields. (2) result-field: a value that is missing
/// or not as expected, or contradicts another. (3) result-edited: not the bytes that gougecheck wrote.
[[nodiscard]] Result<StoredResult> read_result(const std::string& file, std::string_view bytes);

}  // namespace gouge

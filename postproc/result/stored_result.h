#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/result.h"
#include "postproc/record/read_record.h"
#include "postproc/record/result_record.h"

// A result file that is read back for comparisons and acceptances: its record, verified by its digest, and its
// findings.

namespace gouge {

/// Keys of `options.more` that name the law of motion.
inline constexpr std::array<const char*, 10> kLawOptions = {
    "machine",        "feed-law",    "rapid-law",   "tool-length", "tip-tolerance",
    "axis-tolerance", "joint-limit", "joint-point", "joint-rate",  "zero"};

/// Options of the check that affect its gouges.
struct StoredOptions {
  double tolerance_mm = 0, resolution_mm = 0, stock_to_leave_mm = 0, shank_clearance_mm = 0, holder_clearance_mm = 0;
  std::string rapid;
  std::vector<std::string> limits{};  ///< limits of single files, as typed: "vise.stl,clearance=1"; sorted
  /// The law of motion: "machine=preset:NAME", "feed-law=axis", the checksum of a machine file; sorted. Empty: the axis
  /// turns on the great circle.
  std::vector<std::string> law{};

  bool operator==(const StoredOptions&) const = default;
};

/// A result that was read. Lengths are in mm.
struct StoredResult {
  std::string file;  ///< the name of the file
  ResultRecord record;
  StoredOptions options;
  std::vector<EventRecord> findings;  ///< gouges and buried tools, in the order of the path

  /// Returns the record of a move; null if the move is clean.
  [[nodiscard]] const MoveRecord* find_move(std::size_t move) const;
  /// Returns the moves of a finding, in order: those of its interval and state.
  [[nodiscard]] std::vector<const MoveRecord*> moves_of(const EventRecord& finding) const;
  [[nodiscard]] const MoveRecord& worst_of(const EventRecord& finding) const { return *find_move(finding.worst_move); }
  /// Returns the run of a move. Requires a move of the path.
  [[nodiscard]] const RunRecord& run_of(std::size_t move) const;
  /// Returns how many of the moves [first, end) have the operation and tool of `run`.
  [[nodiscard]] std::size_t moves_like(const RunRecord& run, std::size_t first, std::size_t end) const;
  /// Returns the checksums of the files with a role, in order, one in each line.
  [[nodiscard]] std::string contents_of(std::string_view role) const;
};

/// Returns the label of a tool by its key: "T1", a quoted name, or "the unnamed tool".
[[nodiscard]] std::string stored_tool_label(const std::string& key);
/// Returns a finding without its location, in the unit of its result. An example is "0.213 mm cutter T1 at (12.3, 4.5,
/// 6.7), move 118".
[[nodiscard]] std::string stored_finding_text(const StoredResult& result, const EventRecord& finding);

/// Returns the error about a value of a record that contradicts another; none if they agree. `file` is its name.
[[nodiscard]] std::optional<Diagnostic> find_contradiction(const std::string& file, const ReadRecord& read);

/// Reads the bytes of `file`.
/// Errors, with the line: those of read_record. Also result-format (an older version lacks necessary data),
/// result-field (a value contradicts another), and result-edited (the bytes were changed after gougecheck wrote them).
[[nodiscard]] Result<StoredResult> read_result(const std::string& file, std::string_view bytes);

}  // namespace gouge

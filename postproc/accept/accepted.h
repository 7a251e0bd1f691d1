#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/result.h"
#include "postproc/accept/accepted_setup.h"
#include "postproc/result/stored_result.h"

// Accepted findings as a file: docs/formats/accepted.md. Lengths are in mm.

namespace gouge {

/// A motion that may gouge, with its maximum depth.
struct AcceptedMove {
  std::string motion;  ///< motion_key
  double depth_mm = 0, depth_upper_mm = 0;
  std::optional<double> overcut_upper_mm;  ///< none: it was not measured
  std::size_t passes = 1;  ///< how often this motion gouged in the result; the maximum for a later result
};

struct Acceptance {
  std::string reason, by, date;
  std::string finding, toolpath, statement;  ///< for the reader of the file: the accepted finding, and its place
  std::size_t line = 0;
  std::string tool, body, against;  ///< the tool is given by its key
  AcceptedSetup setup;
  std::vector<AcceptedMove> moves;
};

/// Reads the bytes of `file`.
/// Errors, with the line: accepted-syntax, accepted-duplicate-key, json-too-deep, json-too-long. (1) accepted-format:
/// it is not a file of accepted findings. (2) accepted-field: a field is missing or not as expected. (3)
/// accepted-edited: an entry was changed after it was written, or is there twice.
[[nodiscard]] Result<std::vector<Acceptance>> read_accepted(const std::string& file, std::string_view bytes);

/// Returns the text of the file, in which each entry has a seal of its contents. It reads back as the same entries.
[[nodiscard]] std::string write_accepted(const std::vector<Acceptance>& entries);

/// Returns the text of one entry with its seal, as it stands in the file.
[[nodiscard]] std::string write_entry(const Acceptance& entry);

/// The person, reason and date of an acceptance.
struct AcceptanceNote {
  std::string reason, by, date;
};

/// Returns the acceptance of finding `number` of a result.
/// Errors: (1) usage: no finding has this number. (2) accept-impossible: the tool is buried, a depth is not certified,
/// or the tool is unknown and so cannot be compared later.
[[nodiscard]] Result<Acceptance> accept_finding(const StoredResult& result, std::size_t number,
                                                const AcceptanceNote& note);

/// Returns what a move leaves beside its gouge, for a sentence that begins with the move: "has more than this gouge: ..."
/// for remaining stock, else "leaves more open: ...". `reason` is that of the move.
[[nodiscard]] std::string more_text(const std::string& reason);

}  // namespace gouge

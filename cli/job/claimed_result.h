#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "cli/options/job_options.h"
#include "lib/base/result.h"
#include "lib/verify/claims.h"
#include "postproc/record/result_digest.h"
#include "postproc/record/result_record.h"
#include "postproc/report/report_model.h"

// A result that is read back from JSON: the inputs of the check, its options, and its claims.

namespace gouge {

struct ClaimedResult {
  JobArguments arguments;  ///< files, tools and options for reading them, as given to the command that wrote the result
  JobOptions options;
  std::vector<InputFile> inputs;         ///< those that the check itself reads
  std::vector<InputFile> beside_inputs;  ///< the baseline and the project file
  std::string not_recorded;  ///< the first part, fixture or tool whose file the result does not name; empty: none
  std::string program;       ///< name and version
  std::string verdict;       ///< the word that the result states
  int exit_status = 0;
  bool has_baseline = false;                                 ///< some gouges may be accepted
  bool has_excess = false;                                   ///< material left on the parts was asked for
  bool has_material_left = false, is_material_open = false;  ///< at some place of the parts
  std::vector<std::string> open_facts;                       ///< assumptions that the result calls open
  std::vector<std::string> hidden_facts;  ///< contradicted or unknown assumptions that it does not call open
  double mm_per_unit = 1;
  TotalsRecord totals;                      ///< as the result states them, independent of the toolpath
  std::map<std::size_t, MoveClaim> claims;  ///< claims of all moves that are not clean
  bool names_a_move_twice = false;
  DigestState digest = DigestState::missing;
  double largest_overcut_mm = 0;  ///< of all moves

  struct Finding {
    ClaimedState state = ClaimedState::not_checked;
    std::size_t first_move = 0, last_move = 0, worst_move = 0;
  };
  std::vector<Finding> findings;
  std::string malformed;  ///< a value that contradicts another, so that other commands refuse it; empty: none
  ResultRecord record;    ///< all of it, with the names of files as stated

  /// Returns one claim for each move of a path.
  [[nodiscard]] std::vector<MoveClaim> claims_of(std::size_t path_moves) const;
};

/// Reads the result `file`. An input that is not at the stated place is searched for beside the result.
/// Errors  (1) Those of JSON (result-syntax, result-duplicate-key, json-too-deep, json-too-long). (2) result-invalid:
///         it is not a result of `check`, or has an impossible option. (3) result-field with the line: a value is
///         missing or not as expected.
[[nodiscard]] Result<ClaimedResult> read_claimed_result(const std::string& file, std::string_view bytes);

/// Returns contradictions within a result and with its verdict; none if it is consistent.
[[nodiscard]] std::vector<std::string> find_contradictions(const ClaimedResult& result);

}  // namespace gouge

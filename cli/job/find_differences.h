#pragma once

#include <string>
#include <vector>

#include "cli/job/claimed_result.h"
#include "cli/job/expected_record.h"

namespace gouge {

/// Differences of a result from the record that follows from its moves and inputs. Each is a text such as "its
/// '/events/0/line' is 99, and its moves and inputs give 12".
struct RecordDifferences {
  std::vector<std::string> wrong;
  bool is_placement_open = false;  ///< what it states of the placement depends on clean moves, which are not listed
};

/// Compares every field of a result that its moves and inputs determine: promise, facts, toolpath, meshes, tools, totals,
/// findings, acceptances, reasons, moves, runs and motions. With --warnings-as-errors also the warnings about inputs. Cures
/// of findings are not compared, nor sections that the expected record does not have. Texts for people are compared only if this version of the program wrote the result.
[[nodiscard]] RecordDifferences find_differences(const ClaimedResult& result, const ExpectedRecord& expected);

}  // namespace gouge

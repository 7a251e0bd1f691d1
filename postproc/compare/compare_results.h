#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "lib/base/exit_code.h"
#include "postproc/compare/compare_excess.h"
#include "postproc/result/stored_result.h"

namespace gouge {

/// A finding of the new run with the earlier findings that match it, or a finding of the old run that is gone.
struct ComparedFinding {
  Change change = Change::same;
  std::vector<std::size_t> before;  ///< indices of findings of the old run
  std::vector<std::size_t> after;   ///< indices of findings of the new run: one, or none for gone and not_checked
  std::string why;                  ///< reason of deeper and not_checked; may be empty
};

struct Comparison {
  const StoredResult* before = nullptr;
  const StoredResult* after = nullptr;
  /// First the findings of the new run in the order of its path, then the others in the order of the old path.
  std::vector<ComparedFinding> findings;
  std::vector<std::string> differences;  ///< between the set-ups of both runs, a sentence each
  /// number of moves of the new run that are not checked, except those excluded on request
  std::size_t open_moves = 0;
  /// facts on which the verdict of the new run rests, and which are open there and were not before, a sentence each
  std::vector<std::string> open_facts = {};
  std::optional<ExcessComparison> excess = {};  ///< none: no run found material left on the parts

  [[nodiscard]] std::size_t count(Change change) const;
  /// Returns 1 if a finding, or material left on the parts, is new or deeper. Else returns 4 if the new run left one
  /// unchecked, or has open moves or newly open facts; else 0.
  [[nodiscard]] ExitCode exit_status() const;
};

struct CompareOptions {
  double same_within_mm = 0.001;  ///< depths that differ by at most this count as equal
};

/// Compares two results, which must outlive the comparison. The rules of matching: docs/formats/compare.md.
[[nodiscard]] Comparison compare_results(const StoredResult& before, const StoredResult& after,
                                         const CompareOptions& options);

}  // namespace gouge

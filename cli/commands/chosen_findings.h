#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/commands/batch_results.h"
#include "lib/base/diagnostic.h"

// The findings that --finding of `accept` names: 3, 3-6, or JOB:3-6 for a job of a batch.

namespace gouge {

/// A finding of a result.
struct ChosenFinding {
  std::string job;  ///< empty: of the only result
  std::uint32_t number = 0;

  auto operator<=>(const ChosenFinding&) const = default;
  /// Returns the form of --finding.
  [[nodiscard]] std::string text() const;
};

/// Parses one value of --finding: ranges with commas between them. A job holds for the ranges after it too. Returns
/// nothing for another text, and for a range that is empty or has more numbers than a result has findings. The name of a
/// job may have colons and commas.
[[nodiscard]] std::optional<std::vector<ChosenFinding>> parse_findings(const std::string& text);

/// Returns the error about a choice that does not name exactly one of the results, which have no name if they were given
/// alone. Code: usage.
[[nodiscard]] std::optional<Diagnostic> find_wrong_choice(const std::vector<ChosenFinding>& findings,
                                                          const std::vector<ListedJob>& results);

}  // namespace gouge

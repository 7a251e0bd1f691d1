#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "lib/base/diagnostic.h"
#include "postproc/accept/accepted.h"
#include "postproc/result/stored_result.h"

namespace gouge {

/// Outcome of accepting findings of one result.
struct AcceptedFindings {
  std::vector<Acceptance> made;    ///< new entries
  std::vector<std::size_t> known;  ///< numbers of the findings that need no new entry, ascending
  Diagnostics refused;             ///< errors of accept_finding
  std::vector<std::size_t> kept;   ///< numbers of all findings that were not refused, ascending
};

/// Makes entries for the findings `numbers` of a result, beside the entries `accepted`. A finding needs an entry unless
/// apply_acceptances accepts all its moves by the others.
[[nodiscard]] AcceptedFindings accept_findings(const StoredResult& result, std::vector<std::size_t> numbers,
                                               const AcceptanceNote& note, const std::vector<Acceptance>& accepted);

/// A finding that apply_acceptances does not accept, with the reason if an entry has one of its motions.
struct UnacceptedFinding {
  std::size_t number = 0;
  std::string why;
};

/// Returns those of the findings `numbers` of a result that the entries do not accept.
[[nodiscard]] std::vector<UnacceptedFinding> find_unaccepted(const StoredResult& result,
                                                             const std::vector<std::size_t>& numbers,
                                                             const std::vector<Acceptance>& accepted);

}  // namespace gouge

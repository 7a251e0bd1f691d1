#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "postproc/accept/accepted.h"
#include "postproc/result/stored_result.h"

namespace gouge {

/// Who accepts, why and when.
struct AcceptanceNote {
  std::string reason, by, date;
};

/// Accepts finding `number` of a result, beside what `accepted` has already.
/// Errors: usage (no finding of that number); accept-impossible (buried, a depth that is not certified, a tool that is not
/// known: what nobody can compare later); accept-twice (it is accepted already).
[[nodiscard]] Result<Acceptance> accept_finding(const StoredResult& result, std::size_t number,
                                                const AcceptanceNote& note, const std::vector<Acceptance>& accepted);

}  // namespace gouge

#pragma once

#include <optional>
#include <string>

#include "postproc/compare/match_findings.h"
#include "postproc/result/stored_result.h"

namespace gouge {

/// Returns why it is unknown whether a finding of the old run, which the new run does not have, is gone. Its motion was
/// not checked there, not as strictly, or not with that body. Returns nothing if the new run checked the motion of the
/// finding.
[[nodiscard]] std::optional<std::string> why_not_gone(const StoredResult& before, const StoredResult& after,
                                                      const MotionAlignment& motions, const EventRecord& finding);

}  // namespace gouge

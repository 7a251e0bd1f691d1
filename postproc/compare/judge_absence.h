#pragma once

#include <optional>
#include <string>

#include "postproc/compare/match_findings.h"
#include "postproc/result/stored_result.h"

namespace gouge {

/// Returns why it is not known that a finding of the old run, absent from the new run, is gone. Its motion was not
/// checked there, or not as strictly, or not with that body. Nothing where the new run checked the motion of the
/// finding.
[[nodiscard]] std::optional<std::string> why_not_gone(const StoredResult& before, const StoredResult& after,
                                                      const MotionAlignment& motions, const EventRecord& finding);

}  // namespace gouge

#pragma once

#include "lib/check/check_result.h"
#include "lib/path/toolpath.h"

namespace gouge {

/// Fills the events, the counts and the worst move of a result from its verdicts, anew.
///
/// Neighbouring moves of one state, tool, operation, body and counterpart are one event, in path order; buried ones
/// only with the same reason. Clean and not-checked moves make none.
void summarise(const Toolpath& toolpath, CheckResult& result);

}  // namespace gouge

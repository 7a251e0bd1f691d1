#pragma once

#include <string>

#include "lib/check/check_result.h"

namespace gouge {

/// Returns the section "What the verdict rests on" of the report page; empty without facts.
[[nodiscard]] std::string assumptions_html(const CheckResult& result);

}  // namespace gouge

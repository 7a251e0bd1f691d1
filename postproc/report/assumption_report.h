#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "lib/check/check_result.h"

// The assumptions of a verdict, for programs and for people.

namespace gouge {

/// Returns one object for each fact, with every field of Assumption but its code.
[[nodiscard]] nlohmann::ordered_json assumptions_json(const CheckResult& result);

/// Returns the section "What the verdict rests on" of the report page; empty without facts.
[[nodiscard]] std::string assumptions_html(const CheckResult& result);

}  // namespace gouge

#pragma once

#include <nlohmann/json.hpp>

#include "postproc/compare/compare_results.h"

namespace gouge {

/// Returns the comparison of two results as JSON: docs/formats/compare.md.
[[nodiscard]] nlohmann::ordered_json comparison_object(const Comparison& comparison);

}  // namespace gouge

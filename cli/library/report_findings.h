#pragma once

#include <vector>

#include "cli/library/checked_path.h"

namespace gougecheck {

/// Returns the findings of a result: its gouges, buried tools and near misses in the order of the path, then one for
/// each reason why moves are open.
[[nodiscard]] std::vector<Finding> findings_of(const CheckedPath& checked, const gouge::CheckResult& result);

}  // namespace gougecheck

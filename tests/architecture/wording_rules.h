#pragma once

#include <vector>

#include "tests/architecture/source_rules.h"

namespace gouge::architecture {

/// Comments of headers begin with no relative clause; headers, texts of the command line and docs use no private words;
/// limits are called maximum and minimum. docs/conventions.md has the rules in prose.
[[nodiscard]] Complaints check_wording(const std::vector<SourceFile>& files);

}  // namespace gouge::architecture

#pragma once

#include <optional>
#include <string>

#include "postproc/compare/change.h"
#include "postproc/result/stored_result.h"

namespace gouge {

/// Change of the material that the whole program leaves on the parts (--excess).
struct ExcessComparison {
  Change change = Change::same;
  std::string text;  ///< a sentence with the heights of both runs
};

/// Returns nothing if neither run found such material. Heights that differ by at most `same_within_mm` count as equal. The
/// rules: docs/formats/compare.md.
[[nodiscard]] std::optional<ExcessComparison> compare_excess(const StoredResult& before, const StoredResult& after,
                                                             double same_within_mm);

}  // namespace gouge

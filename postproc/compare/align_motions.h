#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace gouge {

/// Which move of one path is which of another; kNone where there is none. Both vectors are increasing where they are not
/// kNone, and each is the inverse of the other.
struct MotionAlignment {
  std::vector<std::size_t> before_to_after, after_to_before;
};

/// Aligns two lists of motions: what is equal at both ends; between them those that are there once in both, as many as
/// stand in one order, and what is equal beside them. Cost: n log n. Source: B. Cohen's patience diff (2005).
[[nodiscard]] MotionAlignment align_motions(const std::vector<std::string>& before,
                                            const std::vector<std::string>& after);

}  // namespace gouge

#pragma once

#include <limits>
#include <optional>

#include "postproc/result/stored_result.h"

namespace gouge {

inline constexpr double kAnyDepth_mm = std::numeric_limits<double>::infinity();

/// Bounds of a depth: at least `low_mm`, at most `high_mm`.
struct DepthBounds {
  double low_mm = 0, high_mm = 0;
};

/// Returns the depth of one body in one obstacle during a move that is listed, from its witness or its further contacts.
/// A buried tool is deeper than every depth. None: the move states no contact of them.
[[nodiscard]] std::optional<DepthBounds> contact_depth(const MoveRecord& move, Body body, Against against);

}  // namespace gouge

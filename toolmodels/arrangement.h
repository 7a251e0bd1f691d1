#pragma once

#include <optional>
#include <vector>

#include "toolmodels/profile.h"

namespace gouge::detail {

/// A piece of a curve between two vertices of the arrangement, which it meets at its ends alone.
struct CurvePiece {
  ProfileElement curve;
  std::size_t from = 0, to = 0;
};

/// Directed curves cut where they meet one another and the axis, at r >= 0. Ends that lie within the slack are one
/// vertex. Given ends come before computed ones, so that given corners keep their digits.
/// Ensures  A piece that two curves share is there once, named by the first. One that two curves run along in opposite
///          directions is left out: there is solid on both sides of it.
struct Arrangement {
  std::vector<Vec2> vertices;
  std::vector<CurvePiece> pieces;
};

[[nodiscard]] Arrangement arrange(const std::vector<ProfileElement>& curves, double slack_mm);

/// Finds the contour along pieces from the lowest of their ends on the axis to the highest, turning right where there
/// is a choice. That is the outer boundary of the solid on its left. Returns nothing when there is no such contour.
[[nodiscard]] std::optional<std::vector<ProfileElement>> outer_contour(const Arrangement& arrangement);

}  // namespace gouge::detail

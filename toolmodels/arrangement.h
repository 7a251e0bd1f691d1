#pragma once

#include <optional>
#include <vector>

#include "toolmodels/profile.h"

namespace gouge::detail {

/// A piece of a curve between two vertices of the arrangement. It has no vertex but its ends.
struct CurvePiece {
  ProfileElement curve;
  std::size_t from = 0, to = 0;
};

/// Directed curves, cut where they meet one another and the axis; all pieces have r >= 0. Ends that lie within the
/// slack are one vertex. Given ends are added before computed ones, so that given corners keep their digits.
/// Ensures  A piece that two curves share is there once and names the first curve. A piece that two curves run along in
///          opposite directions is left out, because the solid lies on both sides of it.
struct Arrangement {
  std::vector<Vec2> vertices;
  std::vector<CurvePiece> pieces;
};

[[nodiscard]] Arrangement arrange(const std::vector<ProfileElement>& curves, double slack_mm);

/// Finds the contour that follows the pieces from their lowest end on the axis to the highest. Where several pieces
/// continue, it takes the one farthest to the right. That is the outer boundary of the solid on its left. Returns
/// nothing if there is no such contour.
[[nodiscard]] std::optional<std::vector<ProfileElement>> outer_contour(const Arrangement& arrangement);

}  // namespace gouge::detail

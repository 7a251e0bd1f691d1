#pragma once

#include <optional>
#include <vector>

#include "lib/tool/compiled_tool.h"
#include "toolmodels/convex_cell.h"

// The 2D Voronoi diagram of a closed half profile, element by element. It consists of the domain of each element, which
// is bounded by normals at its ends, and of its distance there. An element can be nearest only in its domain. For two
// elements it has the curve on which their distances are equal: the bisector itself. No false branch of a squared
// equation is left in the cell in which the curve is used.

namespace gouge::detail {

/// A distance as a function of q: linear, direction . (q - through), or circular, sign |q - center| + shift.
struct DistanceForm {
  bool is_linear = true;
  Vec2 through = Vec2::Zero(), direction = Vec2::Zero();
  Vec2 center = Vec2::Zero();
  double sign = 1, shift = 0;

  [[nodiscard]] DistanceForm negated() const;
};

/// Returns the signed distance of an element, positive outside, valid within its domain.
[[nodiscard]] DistanceForm signed_form(const BoundaryElement& element);

/// A bound of a domain, which is the intersection of half planes {sign * line >= 0}. Neighbours share their lines, so
/// domains leave no gap and do not overlap: every point is on one side of a shared line.
struct DomainBound {
  std::size_t line = 0;
  int sign = 1;
};

struct Domains {
  std::vector<DirectedLine> lines;
  std::vector<std::vector<DomainBound>> bounds;  ///< for each element; an element without bounds is valid everywhere
};

/// Builds the domains. Requires elements in contour order with a vertex at every joint that is not smooth.
[[nodiscard]] Domains make_domains(const std::vector<BoundaryElement>& elements);

/// Returns true only if `f` <= `g` all over the cell (up to its slack). False may also mean that this was not proved.
/// Ensures  True is proved: for convex f and concave g exactly at the corners, else with tangents.
[[nodiscard]] bool is_everywhere_below(const DistanceForm& f, const DistanceForm& g, const ConvexCell& cell);

/// The result of a comparison of two distances within a cell.
struct Comparison {
  enum class Kind { first_nearer, second_nearer, curve, split_first } kind = Kind::curve;
  BspNode curve;      ///< for `curve`: negative where the first distance is smaller; its children are not set
  DirectedLine line;  ///< for `split_first`: cut the cell here, then compare again; also the curve if it is straight
  bool is_straight = false;
};

/// Compares two distances. Requires that both forms are the (unsigned) distances all over the cell.
[[nodiscard]] Comparison compare(const DistanceForm& first, const DistanceForm& second, const ConvexCell& cell);

/// Returns the node of the curve {line = 0}.
[[nodiscard]] BspNode straight_node(const DirectedLine& line);

}  // namespace gouge::detail

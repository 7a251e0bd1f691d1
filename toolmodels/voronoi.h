#pragma once

#include <optional>
#include <vector>

#include "lib/tool/compiled_tool.h"
#include "toolmodels/convex_cell.h"

// The 2D Voronoi diagram of a closed half profile, element by element. It gives where an element can be nearest at all
// (its domain, bounded by normals at its ends), and its distance there. It also gives the curve on which two distances
// are equal. Each curve is the bisector itself: no false branch of a squared equation is left in the cell it is used
// in.

namespace gouge::detail {

/// A distance as a function: linear, direction . (q - through), or circular, sign |q - center| + shift.
struct DistanceForm {
  bool is_linear = true;
  Vec2 through = Vec2::Zero(), direction = Vec2::Zero();
  Vec2 center = Vec2::Zero();
  double sign = 1, shift = 0;

  [[nodiscard]] DistanceForm negated() const;
};

/// Returns the signed distance of an element, positive outside, valid within its domain.
[[nodiscard]] DistanceForm signed_form(const BoundaryElement& element);

/// A domain is the intersection of half planes {sign * line >= 0}. Neighbours share their lines, so domains
/// leave no gap and do not overlap: what one side of a line excludes, the other side holds.
struct DomainBound {
  std::size_t line = 0;
  int sign = 1;
};

struct Domains {
  std::vector<DirectedLine> lines;
  std::vector<std::vector<DomainBound>> bounds;  ///< per element; none means everywhere
};

/// Requires elements in contour order with a vertex at every joint that is not smooth.
[[nodiscard]] Domains make_domains(const std::vector<BoundaryElement>& elements);

/// Returns true when `f` <= `g` all over the cell (up to its slack). False may also mean: not seen.
/// Ensures  Never true wrongly. Convex f and concave g are decided exactly at the corners, else by tangents.
[[nodiscard]] bool is_everywhere_below(const DistanceForm& f, const DistanceForm& g, const ConvexCell& cell);

/// Comparison of two distances within a cell.
struct Comparison {
  enum class Kind { first_nearer, second_nearer, curve, split_first } kind = Kind::curve;
  BspNode curve;      ///< kind curve: negative where the first is nearer; children unset
  DirectedLine line;  ///< kind split_first: cut the cell here, then query again; also the curve when it is straight
  bool is_straight = false;
};

/// Requires that both forms are the (unsigned) distances all over the cell.
[[nodiscard]] Comparison compare(const DistanceForm& first, const DistanceForm& second, const ConvexCell& cell);

/// Returns the curve {line = 0} as a node.
[[nodiscard]] BspNode straight_node(const DirectedLine& line);

}  // namespace gouge::detail

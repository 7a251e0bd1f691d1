#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "lib/geom/pose.h"
#include "lib/geom/vec.h"

// The tool in the form for the check: a closed solid of revolution about the tool axis. It is described by the boundary
// of its half profile in the (r, z) plane, in mm. There r >= 0, z = 0 at the tip, and z grows towards the spindle. In
// addition it has a BSP over the 2D Voronoi diagram of that boundary, or a tree over the boundary itself. It is plain
// data: `toolmodels` compiles it from named dimensions, `evaluate.h` evaluates it.
// Source: Ho 1999 as described in thesis 2.4.18 and appendix C.

namespace gouge {

/// The bodies of a tool's profile, from the tip up, and a head. The head moves with the tool but is not part of it.
enum class Body : std::uint8_t { cutter, shank, holder, head };
[[nodiscard]] const char* body_name(Body body);

enum class ElementKind : std::uint8_t { segment, arc, vertex };

/// Range in which the plane tangent to the boundary at a foot on this element bounds the solid. Two cases bound
/// nothing: an empty range (z_lo > z_hi), and a normal towards the axis (n_r < 0, in a hollow underside).
/// Let Q be a convex query hull in tool coordinates, n the outward normal, and {n.x = n.foot} the plane. Requires: (1)
/// The z of every point of Q lies in [z_lo, z_hi]. (2) For points behind the plane, the z of their projection onto it
/// lies in that range too. (3) Every point of Q has r >= r_min. Then depth(q) <= max(0, n.foot - n.q) for every q in Q.
/// Proof: docs/method/certified_sweep.md.
struct SupportRange {
  double z_lo_mm = 0;
  double z_hi_mm = -1;
  double r_min_mm = 0;
};

/// One feature of the boundary, in the order of the contour from the tip to the top. A vertex is the point where two
/// features meet. It owns the points that are not nearest to any open segment or arc.
struct BoundaryElement {
  ElementKind kind = ElementKind::segment;
  Body body = Body::cutter;
  bool is_reflex = false;      ///< arc: solid outside the circle; vertex: interior angle above 180 degrees
  Vec2 a = Vec2::Zero();       ///< start on the contour; a vertex has a == b
  Vec2 b = Vec2::Zero();       ///< end on the contour
  Vec2 center = Vec2::Zero();  ///< arcs: centre of the circle
  double radius_mm = 0;        ///< arcs: its radius
  /// Segment: outward unit normal. Vertex: outward mean direction. Arc: unit direction from the centre to the middle of
  /// the arc. A query returns this vector where the gradient is undefined (on a vertex, at a centre).
  Vec2 normal = Vec2::Zero();
  SupportRange support;
};

/// A node of the BSP. A leaf names the nearest element. An inner node is a curve f whose sign selects the child: f =
/// linear v + square v^2 + round (x^2 + y^2). Here v = v0 + vx x + vy y and (x, y) = (r, z) - origin. A line has the
/// first term alone. Every other bisector compares a distance from the origin, its focus, with a linear function. In
/// this form f stays accurate for features that are far apart or almost equal.
struct BspNode {
  Vec2 origin = Vec2::Zero();
  double v0 = 0, vx = 0, vy = 0;
  double linear = 0, square = 0, round = 0;
  std::int32_t negative = -1;  ///< child where f < 0; >= 0: a node; otherwise ~element
  std::int32_t positive = -1;  ///< child where f >= 0
};

/// Border between the domains of two consecutive elements (the points to which each can be nearest).
/// offset + direction . (q - through) is negative on the side of the first element.
struct DomainBorder {
  Vec2 through = Vec2::Zero();
  Vec2 direction = Vec2::Zero();
  double offset = 0;
};

/// Consecutive elements in a box along the chord from the start of the first element to the end of the last one. Every
/// point of them is origin + u along + v left, with (u, v) in [low, high]. Here left is `along` turned by +90 degrees.
struct ContourStretch {
  std::uint32_t first = 0, last = 0;  ///< elements [first, last)
  std::uint32_t second = 0;           ///< its halves are the next stretch and stretch `second`; 0: it is not divided
                                      ///< further
  Vec2 origin = Vec2::Zero();
  Vec2 along = Vec2::UnitX();  ///< unit
  Vec2 low = Vec2::Zero(), high = Vec2::Zero();
};

struct CompiledTool {
  std::string name;
  std::vector<BoundaryElement> elements;
  /// borders[i] lies between elements[i] and elements[i + 1]; empty if the contour turns back on itself.
  std::vector<DomainBorder> borders;
  std::vector<BspNode> nodes;  ///< nodes[0] is the root; empty if there is a single element or a tree of stretches
  /// A tree over the contour in place of the BSP, for tools of many elements: [0] is the root, children follow their
  /// parent.
  std::vector<ContourStretch> stretches;
  double z_min_mm = 0, z_max_mm = 0, r_max_mm = 0;
  /// The deepest point on the axis (r = 0) inside the cutter's part of the solid. If the axis is nowhere inside the
  /// cutter, it is the deepest point inside the whole solid.
  Vec2 core = Vec2::Zero();
  double core_depth_mm = 0;  ///< depth of `core`
};

}  // namespace gouge

#pragma once

#include <string>
#include <vector>

#include "lib/geom/vec.h"
#include "lib/tool/compiled_tool.h"

// The boundary of a tool's half section: segments and circular arcs in the (r, z) half plane, r >= 0, mm. The contour
// starts on the axis at the tip and ends on the axis at the top; the axis closes it. The solid is on its left. So
// convex arcs run counter-clockwise, and concave ones clockwise.
//
//      z ^ <--------+
//        |  solid   |
//        |         /        outward normal: on the right of the direction of travel
//        +---------->  r

namespace gouge {

struct ProfileElement {
  Body body = Body::cutter;
  bool is_arc = false;
  bool is_concave = false;     ///< arc with the solid outside its circle
  Vec2 a = Vec2::Zero();       ///< start
  Vec2 b = Vec2::Zero();       ///< end
  Vec2 center = Vec2::Zero();  ///< of an arc
  double radius_mm = 0;        ///< of an arc
};

struct Profile {
  std::vector<ProfileElement> elements;
};

[[nodiscard]] ProfileElement make_segment(Body body, const Vec2& a, const Vec2& b);
[[nodiscard]] ProfileElement make_convex_arc(Body body, const Vec2& a, const Vec2& b, const Vec2& center,
                                             double radius_mm);
[[nodiscard]] ProfileElement make_concave_arc(Body body, const Vec2& a, const Vec2& b, const Vec2& center,
                                              double radius_mm);

/// Returns the unit direction of travel at the start and at the end. Requires an element that verify_profile accepts.
[[nodiscard]] Vec2 start_direction(const ProfileElement& element);
[[nodiscard]] Vec2 end_direction(const ProfileElement& element);

/// Returns the outward unit normal belonging to a direction of travel.
[[nodiscard]] inline Vec2 outward_normal(const Vec2& direction) { return {direction.y(), -direction.x()}; }

/// Returns the angle an arc sweeps, in (0, 2 pi); 0 for a segment.
[[nodiscard]] double sweep_rad(const ProfileElement& element);

/// Returns the element as points: its two ends for a segment, `steps` + 1 points for an arc.
[[nodiscard]] std::vector<Vec2> sample(const ProfileElement& element, int steps);

/// Returns the largest coordinate of the contour. Tolerances relative to the tool's size refer to this length.
[[nodiscard]] double size_of(const Profile& profile);

/// Returns whether every height has one radius: the solid is {r <= rho(z)}, and has no undercut in the radial
/// direction.
[[nodiscard]] bool is_single_valued(const Profile& profile);

/// Returns the broken invariants; empty if the contour is a closed half section. (1) It starts and ends on the axis and
/// touches it nowhere else. (2) Elements join end to start, have length, and lie on their circles. (3) They do not
/// cross or touch, and the solid is on their left. At most about a hundred crossings are named.
/// Cost     O(n log n) for n elements whose boxes do not meet, in the worst case quadratic. Arcs are examined as
///          polygons of 48 chords.
[[nodiscard]] std::vector<std::string> verify_profile(const Profile& profile);

}  // namespace gouge

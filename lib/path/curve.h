#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "lib/geom/vec.h"

// The curves that a tip may follow between two positions instead of a straight line; mm, part coordinates. Moves refer
// to their curve by index (Toolpath::arcs, Toolpath::splines), because most moves have none.

namespace gouge {

enum class CurveKind : std::uint8_t { none, arc, spline };

/// A circle or a helix about `center + s axis`. Because of the file's rounding, start and end may differ in their
/// distance from that line. Then the radius changes evenly, and so does the height. So the tip moves exactly from the
/// start to the end of its move, whatever the numbers state.
struct PathArc {
  Vec3 center = Vec3::Zero();
  Vec3 axis = Vec3::UnitZ();  ///< unit
  double sweep_rad = 0;       ///< right-handed about `axis`; 2 pi is a full circle, larger values are several turns
};

/// One cubic Bezier piece over the parameters [u0, u1] of its spline.
struct SplinePiece {
  double u0 = 0, u1 = 1;
  std::array<Vec3, 4> control{Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};

  [[nodiscard]] Vec3 at(double u) const;
  /// Bounds the second derivative over the piece. That of a cubic is linear, so its ends suffice.
  [[nodiscard]] double largest_second_derivative() const;
  /// Bounds the length of the tip's path over any share `du` of the piece, divided by `du`.
  [[nodiscard]] double largest_speed() const;
};

/// A cubic spline over the parameters 0 to 1, which are the instants of its move. Its first control point is the start
/// of the move, and its last one the end.
struct PathSpline {
  std::vector<SplinePiece> pieces;
};

/// Builds the Bezier pieces of a cubic B-spline.
///
/// Shape    The `inner_knots` and the end value 1 lie in (0, 1] and do not decrease, as in KNOT/ of an NX CLSF. The
///          knots 0 and 1 occur four times each. There are inner_knots.size() + 4 control points.
/// Errors   The result is empty for too few control points, and for knots that decrease or are outside of (0, 1). It is
///          also empty for a knot that occurs more than three times, because the curve would be broken.
/// Source   Boehm, Inserting new knots into B-spline curves, CAD 12 (1980).
[[nodiscard]] PathSpline make_spline(const std::vector<Vec3>& control, const std::vector<double>& inner_knots);

/// Returns the length of an arc between two tips, also of a helix or spiral.
[[nodiscard]] double arc_length_mm(const PathArc& arc, const Vec3& start, const Vec3& end);

/// Returns the length of a spline, accurate to about a thousandth.
[[nodiscard]] double spline_length_mm(const PathSpline& spline);

}  // namespace gouge

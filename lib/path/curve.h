#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "lib/geom/vec.h"

// The curves a tip may follow between two positions besides the straight one. mm, part coordinates. Moves name
// theirs by index (Toolpath::arcs, Toolpath::splines), because most moves have none.

namespace gouge {

enum class CurveKind : std::uint8_t { none, arc, spline };

/// A circle or a helix about `center + s axis`. Start and end may differ in their distance from that line (by the
/// rounding of the file). Then the radius changes evenly, and so does the height. So the tip runs from the start to the
/// end of its move exactly, whatever the numbers state.
struct PathArc {
  Vec3 center = Vec3::Zero();
  Vec3 axis = Vec3::UnitZ();  ///< unit
  double sweep_rad = 0;       ///< right-handed about `axis`; 2 pi is a full circle, more are several turns
};

/// One cubic Bezier piece over the parameters [u0, u1] of its spline.
struct SplinePiece {
  double u0 = 0, u1 = 1;
  std::array<Vec3, 4> control{Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};

  [[nodiscard]] Vec3 at(double u) const;
  /// Bounds the second derivative over the piece. That of a cubic is linear, so its ends suffice.
  [[nodiscard]] double largest_second_derivative() const;
  /// Bounds the length of the path of the tip over any share `du` of the piece, per `du`.
  [[nodiscard]] double largest_speed() const;
};

/// A cubic spline over the parameters 0 to 1, which are the instants of its move. Its first control point is
/// the start of the move and its last one the end.
struct PathSpline {
  std::vector<SplinePiece> pieces;
};

/// Builds the Bezier pieces of a cubic B-spline.
///
/// Shape    The `inner_knots` and the end value 1 lie in (0, 1] and do not decrease: the form of KNOT/ in an NX CLSF.
///          The value 0 is there four times and 1 four times. There are inner_knots.size() + 4 control points.
/// Errors   Empty result: too few control points, or knots that decrease or leave (0, 1). Also a knot more than three
///          times, as the curve would be broken.
/// Source   Boehm, Inserting new knots into B-spline curves, CAD 12 (1980).
[[nodiscard]] PathSpline make_spline(const std::vector<Vec3>& control, const std::vector<double>& inner_knots);

/// Returns the length of an arc between two tips, helix and spiral included.
[[nodiscard]] double arc_length_mm(const PathArc& arc, const Vec3& start, const Vec3& end);

/// Returns the length of a spline, to about a thousandth of it.
[[nodiscard]] double spline_length_mm(const PathSpline& spline);

}  // namespace gouge

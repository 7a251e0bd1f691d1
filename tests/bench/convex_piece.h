#pragma once

#include <array>
#include <vector>

#include "lib/geom/pose.h"
#include "lib/geom/vec.h"

// The tools of the benchmark in a second description, so that what judges the engine shares no code with it:
// a union of convex solids of revolution, each a polygonal core swept by a ball. The signed distance of such
// a piece is convex, which makes its minimum over a triangle a problem one can close with subgradients alone.

namespace gouge::bench {

struct ConvexPiece {
  std::vector<Vec2> contour;  ///< convex core in (r, z), from the axis outward and back to it; mm
  double rounding_mm = 0;     ///< radius of the ball the core is swept by
};

/// A value of the signed distance and one of its subgradients, in the frame of the pose.
struct PieceSample {
  double distance_mm = 0;
  Vec3 gradient = Vec3::Zero();
};

/// Signed distance of point p from the piece at a pose; negative inside.
[[nodiscard]] PieceSample sample_piece(const ConvexPiece& piece, const Pose& pose, const Vec3& p);

/// The farthest point of the piece in a direction, as an offset from the tip.
[[nodiscard]] Vec3 support_offset(const ConvexPiece& piece, const Vec3& axis, const Vec3& direction);

struct TriangleMinimum {
  double distance_mm = 0;  ///< realised at `point`
  Vec3 point = Vec3::Zero();
};

/// Lowers `best` to the smallest signed distance over the triangle when that is smaller by more than
/// `accuracy_mm`; leaves it alone otherwise. Closed by first-order bounds: no tolerance but the accuracy.
void lower_over_triangle(const ConvexPiece& piece, const Pose& pose, const std::array<Vec3, 3>& triangle,
                         double accuracy_mm, TriangleMinimum& best);

}  // namespace gouge::bench

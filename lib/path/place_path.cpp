#include "lib/path/place_path.h"

namespace gouge {

void place_path(const RigidTransform& place, Toolpath& path) {
  for (Move& move : path.moves) move.end = place.pose(move.end);
  for (PathArc& arc : path.arcs) {
    arc.center = place.point(arc.center);
    arc.axis = place.direction(arc.axis);
  }
  for (PathSpline& spline : path.splines) {
    for (SplinePiece& piece : spline.pieces) {
      for (Vec3& control : piece.control) control = place.point(control);
    }
  }
}

}  // namespace gouge

#include "cli/scene_reach.h"

#include <algorithm>

namespace gouge {
namespace {

double from_axis(const PathArc& arc, const Vec3& point) {
  const Vec3 away = point - arc.center;
  return (away - away.dot(arc.axis) * arc.axis).norm();
}

// An arc's tip is never farther from its axis than the farther of its ends, nor higher or lower than both.
void add_arc(Box3& box, const PathArc& arc, const Vec3& start, const Vec3& end) {
  const double across = 2 * std::max(from_axis(arc, start), from_axis(arc, end));
  for (const Vec3& point : {start, end}) {
    box.extend(Vec3(point - Vec3::Constant(across)));
    box.extend(Vec3(point + Vec3::Constant(across)));
  }
}

}  // namespace

double reach_mm(const Toolpath& path, const Scene& scene) {
  Box3 box;
  for (const std::vector<IndexedMesh>* meshes : {&scene.parts, &scene.fixtures})
    for (const IndexedMesh& mesh : *meshes) box.extend(mesh.box());
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const Move& move = path.moves[i];
    box.extend(move.end.tip);
    if (move.curve_kind == CurveKind::arc) add_arc(box, path.arcs[move.curve], path.start_of(i).tip, move.end.tip);
    if (move.curve_kind == CurveKind::spline)
      for (const SplinePiece& piece : path.splines[move.curve].pieces)
        for (const Vec3& control : piece.control) box.extend(control);
  }
  return box.isEmpty() ? 0 : box.diagonal().norm();
}

}  // namespace gouge

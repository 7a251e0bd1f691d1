#include "cli/scene_reach.h"

#include <algorithm>
#include <cmath>

#include "lib/base/number_text.h"
#include "postproc/report/report_model.h"

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

Box3 box_of_tips(const Toolpath& path) {
  Box3 box;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const Move& move = path.moves[i];
    box.extend(move.end.tip);
    if (move.curve_kind == CurveKind::arc) add_arc(box, path.arcs[move.curve], path.start_of(i).tip, move.end.tip);
    if (move.curve_kind == CurveKind::spline)
      for (const SplinePiece& piece : path.splines[move.curve].pieces)
        for (const Vec3& control : piece.control) box.extend(control);
  }
  return box;
}

// Without rapids, which may come from far away.
Box3 box_of_cuts(const Toolpath& path) {
  Box3 box;
  for (const Move& move : path.moves) {
    if (move.kind != MoveKind::rapid) box.extend(move.end.tip);
  }
  return box;
}

Diagnostic misplaced(const Toolpath& path, const std::string& what) {
  return make_warning(kSceneMisplaced, what + "; check the units (--stl-units, --path-units) and --place", path.file);
}

}  // namespace

double reach_mm(const Toolpath& path, const Scene& scene) {
  Box3 box = box_of_tips(path);
  for (const std::vector<IndexedMesh>* meshes : {&scene.parts, &scene.fixtures})
    for (const IndexedMesh& mesh : *meshes) box.extend(mesh.box());
  return box.isEmpty() ? 0 : box.diagonal().norm();
}

std::optional<Diagnostic> find_misplaced(const Toolpath& path, const Scene& scene, double tool_mm) {
  constexpr double kFarTooSmall = 8;  // times: parts are about as large as what is milled of them
  Box3 parts;
  for (const IndexedMesh& mesh : scene.parts) parts.extend(mesh.box());
  const Box3 tips = box_of_tips(path);
  if (parts.isEmpty() || tips.isEmpty()) return std::nullopt;
  const double gap = std::sqrt(parts.squaredExteriorDistance(tips));
  if (gap > tool_mm) return misplaced(path, "no move comes nearer than " + fixed_text(gap - tool_mm, 0) + " mm to the part");
  const Box3 cuts = box_of_cuts(path);
  if (cuts.isEmpty()) return std::nullopt;
  const double ratio = cuts.diagonal().norm() / std::max(parts.diagonal().norm(), 1e-9);
  if (ratio > kFarTooSmall) return misplaced(path, "the part is " + fixed_text(ratio, 0) + " times smaller than the path");
  return std::nullopt;
}

std::optional<Diagnostic> find_apart(const Toolpath& path, const Closeness& closeness) {
  constexpr std::size_t kFewest = 10;
  constexpr double kApart_mm = 2;  // beyond the stock to leave
  if (closeness.positions < kFewest || closeness.nearest_mm.value_or(Closeness::kFar_mm) <= kApart_mm) return std::nullopt;
  return misplaced(path, "the tool comes no nearer than " +
                             fixed_text(closeness.nearest_mm.value_or(Closeness::kFar_mm), 1) +
                             " mm to the part where it cuts, at " + std::to_string(closeness.positions) +
                             " positions looked at");
}

}  // namespace gouge

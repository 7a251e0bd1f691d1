#include "lib/check/scene_reach.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lib/base/tolerance.h"
#include "lib/check/reach.h"
#include "lib/mesh/indexed_mesh.h"

namespace gouge {

namespace {

double from_axis(const PathArc& arc, const Vec3& point) {
  const Vec3 away = point - arc.center;
  return (away - away.dot(arc.axis) * arc.axis).norm();
}

// Extends the box by an arc. The tip of an arc is never farther from the arc's axis than the farther end, and never
// higher or lower than both ends.
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
    const bool is_arc = move.curve_kind == CurveKind::arc && move.curve < path.arcs.size();
    if (is_arc && i > 0) add_arc(box, path.arcs[move.curve], path.start_of(i).tip, move.end.tip);
    if (move.curve_kind == CurveKind::spline && move.curve < path.splines.size())
      for (const SplinePiece& piece : path.splines[move.curve].pieces)
        for (const Vec3& control : piece.control) box.extend(control);
  }
  return box;
}

// Returns the box of the cuts. Rapids are left out, because they may come from far away.
Box3 box_of_cuts(const Toolpath& path) {
  Box3 box;
  for (const Move& move : path.moves) {
    if (move.kind != MoveKind::rapid) box.extend(move.end.tip);
  }
  return box;
}

double size_of(const Box3& box) { return box.diagonal().norm(); }

}  // namespace

double reach_mm(const Toolpath& path, const Scene& scene) {
  Box3 box = box_of_tips(path);
  for (const ObstacleMeshes& obstacle : obstacles_of(scene)) box.extend(box_of(obstacle.meshes));
  return box.isEmpty() ? 0 : size_of(box);
}

std::optional<PartsBesidePath> compare_parts(const Toolpath& path, const Scene& scene) {
  const Box3 parts = box_of(workpiece_of(scene)), tips = box_of_tips(path), cuts = box_of_cuts(path);
  if (parts.isEmpty() || tips.isEmpty()) return std::nullopt;
  PartsBesidePath found;
  found.gap_mm = std::sqrt(parts.squaredExteriorDistance(tips));
  if (!cuts.isEmpty()) found.times_smaller = size_of(cuts) / std::max(size_of(parts), Tolerance::kSamePoint_mm);
  return found;
}

std::vector<const UnitFacts*> units_that_fit(double times_smaller, LengthUnit stl_unit) {
  constexpr double kAbout = 2.5;  // maximum ratio of two sizes that count as about equal
  std::vector<std::pair<double, const UnitFacts*>> fitting;
  for (const UnitFacts& unit : kUnits) {
    const double left = times_smaller * mm_per(stl_unit) / unit.mm;
    const double off = std::max(left, 1 / left);
    if (off <= kAbout && unit.unit != stl_unit) fitting.emplace_back(off, &unit);
  }
  std::stable_sort(fitting.begin(), fitting.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<const UnitFacts*> units;
  for (const auto& [off, unit] : fitting) units.push_back(unit);
  return units;
}

std::vector<const UnitFacts*> units_in_place(const Toolpath& path, const Scene& scene, LengthUnit stl_unit) {
  constexpr double kOutside = 0.1, kTimesLarger = 20;
  const Box3 parts = box_of(workpiece_of(scene)), cuts = box_of_cuts(path);
  std::vector<const UnitFacts*> units;
  if (parts.isEmpty() || cuts.isEmpty()) return units;
  for (const UnitFacts& unit : kUnits) {
    const double scale = unit.mm / mm_per(stl_unit);
    Box3 scaled(parts.min() * scale, parts.max() * scale);
    const double size = size_of(scaled);
    if (unit.unit == stl_unit || size > kTimesLarger * size_of(cuts)) continue;
    const Vec3 margin = Vec3::Constant(kOutside * size);
    scaled.min() -= margin;
    scaled.max() += margin;
    if (scaled.contains(cuts)) units.push_back(&unit);
  }
  return units;
}

std::optional<Diagnostic> find_too_far(const IndexedMesh& mesh, const std::string& body, const std::string& advice) {
  if (std::all_of(mesh.vertices.begin(), mesh.vertices.end(), is_within_reach)) return std::nullopt;
  return make_error("mesh-too-far",
                    "reaches more than 100 m from the origin; expected a " + body + " within that; check " + advice,
                    mesh.name);
}

}  // namespace gouge

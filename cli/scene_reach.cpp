#include "cli/scene_reach.h"

#include <algorithm>
#include <cmath>
#include <vector>

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

constexpr double kFarOff = 8;  // times: parts are about as large as what is milled of them

Box3 box_of_parts(const Scene& scene) {
  Box3 parts;
  for (const IndexedMesh& mesh : scene.parts) parts.extend(mesh.box());
  return parts;
}

double times_smaller(const Box3& parts, const Box3& path) {
  return path.diagonal().norm() / std::max(parts.diagonal().norm(), 1e-9);
}

// Which units would make the part about as large as the path, the best first; nothing where none does.
std::string unit_hint(double times_smaller, LengthUnit stl_unit) {
  constexpr double kAbout = 2.5;  // times
  std::vector<std::pair<double, const UnitFacts*>> fitting;
  for (const UnitFacts& unit : kUnits) {
    const double left = times_smaller * mm_per(stl_unit) / unit.mm;
    const double off = std::max(left, 1 / left);
    if (off <= kAbout && unit.unit != stl_unit) fitting.emplace_back(off, &unit);
  }
  std::stable_sort(fitting.begin(), fitting.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::string words;
  for (const auto& [off, unit] : fitting)
    words += (words.empty() ? "" : " or ") + std::string("--stl-units ") + std::string(unit->option);
  return words.empty() ? words : "; with " + words + " it would be about as large as the path";
}

}  // namespace

double reach_mm(const Toolpath& path, const Scene& scene) {
  Box3 box = box_of_tips(path);
  for (const std::vector<IndexedMesh>* meshes : {&scene.parts, &scene.fixtures})
    for (const IndexedMesh& mesh : *meshes) box.extend(mesh.box());
  return box.isEmpty() ? 0 : box.diagonal().norm();
}

std::optional<Diagnostic> find_misplaced(const Toolpath& path, const Scene& scene, double tool_mm, LengthUnit stl_unit) {
  const Box3 parts = box_of_parts(scene);
  const Box3 tips = box_of_tips(path);
  if (parts.isEmpty() || tips.isEmpty()) return std::nullopt;
  const double gap = std::sqrt(parts.squaredExteriorDistance(tips));
  const Box3 cuts = box_of_cuts(path);
  const double ratio = cuts.isEmpty() ? 1 : times_smaller(parts, cuts);
  const bool is_of_size = ratio <= kFarOff && ratio >= 1 / kFarOff;
  const std::string hint = is_of_size ? std::string() : unit_hint(ratio, stl_unit);
  if (gap > tool_mm)
    return misplaced(path, "no move comes nearer than " + fixed_text(gap - tool_mm, 0) + " mm to the part" + hint);
  if (ratio > kFarOff)
    return misplaced(path, "the part is " + people_text(ratio, 0) + " times smaller than the path" + hint);
  return std::nullopt;
}

std::optional<Diagnostic> find_too_large(const Toolpath& path, const Scene& scene,
                                         const std::vector<MoveVerdict>& verdicts, LengthUnit stl_unit) {
  const Box3 parts = box_of_parts(scene);
  const Box3 box = box_of_cuts(path);
  if (parts.isEmpty() || box.isEmpty()) return std::nullopt;
  const double ratio = times_smaller(parts, box);
  const std::string hint = unit_hint(ratio, stl_unit);
  if (ratio >= 1 / kFarOff || hint.empty()) return std::nullopt;
  std::size_t cuts = 0, deep = 0;
  for (std::size_t i = 0; i < path.moves.size() && i < verdicts.size(); ++i) {
    if (path.moves[i].kind == MoveKind::rapid) continue;
    ++cuts;
    deep += verdicts[i].state == MoveState::gouge || verdicts[i].state == MoveState::buried ? 1U : 0U;
  }
  if (2 * deep <= cuts) return std::nullopt;
  return misplaced(path, "the part is " + people_text(1 / ratio, 0) + " times larger than the path, and " +
                             std::to_string(deep) + " of " + std::to_string(cuts) + " cuts are in it" + hint);
}

std::optional<Diagnostic> find_apart(const Toolpath& path, const Closeness& closeness) {
  constexpr std::size_t kFewest = 10;
  constexpr double kApart_mm = 2;  // beyond the stock to leave
  const double nearest_mm = closeness.nearest_mm.value_or(Closeness::kFar_mm);
  if (closeness.positions < kFewest || nearest_mm <= kApart_mm) return std::nullopt;
  // Rounded down: it must hold for each of them.
  return misplaced(path, "at none of " + positions_looked_at(closeness) + " is the tool nearer than " +
                             fixed_text(std::floor(closeness.apart_mm * 10) / 10, 1) + " mm to the part");
}

}  // namespace gouge

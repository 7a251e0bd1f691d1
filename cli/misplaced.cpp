#include "cli/misplaced.h"

#include <cmath>
#include <string>

#include "lib/base/number_text.h"
#include "lib/check/scene_reach.h"
#include "postproc/report/report_model.h"

namespace gouge {
namespace {

Diagnostic misplaced(const Toolpath& path, const std::string& what) {
  return make_warning(kSceneMisplaced, what + "; check the units (--stl-units, --path-units) and --place", path.file);
}

// Which units would make the part about as large as the path; nothing where none does.
std::string unit_hint(double times_smaller, LengthUnit stl_unit) {
  std::string words;
  for (const UnitFacts* unit : units_that_fit(times_smaller, stl_unit))
    words += (words.empty() ? "" : " or ") + std::string("--stl-units ") + std::string(unit->option);
  return words.empty() ? words : "; with " + words + " it would be about as large as the path";
}

}  // namespace

std::optional<Diagnostic> find_misplaced(const Toolpath& path, const Scene& scene, double tool_mm,
                                         LengthUnit stl_unit) {
  const std::optional<PartsBesidePath> parts = compare_parts(path, scene);
  if (!parts) return std::nullopt;
  const bool is_of_size = !parts->is_far_smaller() && !parts->is_far_larger();
  const std::string hint = is_of_size ? std::string() : unit_hint(parts->times_smaller, stl_unit);
  if (parts->gap_mm > tool_mm) {
    return misplaced(path,
                     "no move comes nearer than " + fixed_text(parts->gap_mm - tool_mm, 0) + " mm to the part" + hint);
  }
  if (parts->is_far_smaller()) {
    return misplaced(path,
                     "the part is " + people_text(parts->times_smaller, 0) + " times smaller than the path" + hint);
  }
  return std::nullopt;
}

std::optional<Diagnostic> find_too_large(const Toolpath& path, const Scene& scene, const MoveVerdicts& verdicts,
                                         LengthUnit stl_unit) {
  const std::optional<PartsBesidePath> parts = compare_parts(path, scene);
  if (!parts || !parts->is_far_larger()) return std::nullopt;
  const std::string hint = unit_hint(parts->times_smaller, stl_unit);
  if (hint.empty()) return std::nullopt;
  std::size_t cuts = 0, deep = 0;
  for (std::size_t i = 0; i < path.moves.size() && i < verdicts.size(); ++i) {
    if (path.moves[i].kind == MoveKind::rapid) continue;
    ++cuts;
    deep += verdicts[i].state == MoveState::gouge || verdicts[i].state == MoveState::buried ? 1U : 0U;
  }
  if (2 * deep <= cuts) return std::nullopt;
  return misplaced(path, "the part is " + people_text(1 / parts->times_smaller, 0) +
                             " times larger than the path, and " + std::to_string(deep) + " of " +
                             std::to_string(cuts) + " cuts are in it" + hint);
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

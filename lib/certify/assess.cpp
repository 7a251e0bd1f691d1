#include "lib/certify/assess.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "lib/base/number_text.h"
#include "lib/base/tolerance.h"
#include "lib/certify/check.h"
#include "lib/certify/obstructions.h"
#include "lib/certify/placement.h"
#include "lib/certify/settle_ways.h"
#include "lib/check/contact_rule.h"
#include "lib/motion/motion_law.h"

namespace gouge {
namespace {

constexpr double kTouch_mm = 0.01;
constexpr double kNear_mm = 2;  // as far as a roughing cutter may stay from the part

double reach_of_tools_mm(const std::vector<const ToolVariants*>& tools) {
  double reach_mm = 0;
  for (const ToolVariants* tool : tools) {
    if (tool != nullptr) reach_mm = std::max(reach_mm, tool->bare.r_max_mm + tool->bare.z_max_mm);
  }
  return reach_mm;
}

LengthUnit unit_of_meshes(const Toolpath& path, const SetupBasis& basis) { return basis.mesh_unit.value_or(path.unit); }

Assumption mesh_unit_fact(const Toolpath& path, const CheckSetup& setup, const CheckResult& result) {
  const SetupBasis& basis = setup.basis;
  const LengthUnit unit = unit_of_meshes(path, basis);
  Assumption fact{.subject = Subject::mesh_unit, .value = std::string(facts_of(unit).option)};
  fact.code = "mesh-unit";
  fact.file = path.file;
  fact.remedy = "state the unit with --stl-units";
  if (basis.mesh_unit) {
    fact.basis = Basis::stated;
    fact.evidence = "stated by the user";
  } else if (auto size = find_other_size(path, *setup.scene.scene, result.verdicts, unit)) {
    fact.basis = Basis::contradicted;
    fact.code = "scene-misplaced";
    fact.evidence = std::move(*size);
  } else {
    fact.evidence = "STL files state no unit; that of the toolpath was taken";
  }
  return fact;
}

/// Returns whether the path cuts, and none of its cuts was checked: where they are is not known then.
bool are_all_cuts_unknown(const Toolpath& path, const CheckResult& result) {
  std::size_t cuts = 0, checked = 0;
  for (std::size_t i = 0; i < path.moves.size() && i < result.verdicts.size(); ++i) {
    if (path.moves[i].kind == MoveKind::rapid) continue;
    ++cuts;
    checked += result.verdicts[i].state != MoveState::not_checked ? 1U : 0U;
  }
  return cuts > 0 && checked == 0;
}

std::optional<std::string> find_misplacement(const Toolpath& path, const CheckSetup& setup, const CheckResult& result) {
  if (are_all_cuts_unknown(path, result)) return std::nullopt;
  if (auto gap = find_gap(path, *setup.scene.scene, setup.scene.workpiece_tree(), reach_of_tools_mm(setup.tools)))
    return gap;
  if (!result.closest_approach) return std::nullopt;
  return find_apart(*result.closest_approach);
}

/// Returns whether a cutter would come near the part if it were `times` as large.
bool would_touch(const Toolpath& path, const CheckSetup& setup, double times) {
  double radius_mm = 0;
  for (const ToolVariants* tool : setup.tools)
    if (tool != nullptr) radius_mm = std::max(radius_mm, tool->bare.r_max_mm);
  const std::optional<double> nearest_mm = nearest_tip_mm(path, setup.scene.workpiece_tree(), times);
  return nearest_mm && *nearest_mm <= radius_mm + kNear_mm;
}

Assumption placement_fact(const Toolpath& path, const CheckSetup& setup, const CheckResult& result) {
  Assumption fact{.subject = Subject::placement};
  fact.value = setup.basis.place.empty() ? "as the files are" : setup.basis.place + " (mm, degrees)";
  fact.code = "scene-misplaced";
  fact.file = path.file;
  fact.remedy =
      "check units, --place (of a program also --offset) and the sign of the axis, or state that it is right with "
      "--assume placement";
  if (auto misplaced = find_misplacement(path, setup, result)) {
    fact.basis = Basis::contradicted;
    fact.evidence = std::move(*misplaced);
    // A unit that the user states is not doubted, but it may be the mistake. One that is not stated has a fact of its own.
    const Scene& scene = *setup.scene.scene;
    const LengthUnit unit = unit_of_meshes(path, setup.basis);
    const bool is_told = !setup.basis.mesh_unit && find_other_size(path, scene, result.verdicts, unit);
    const bool is_moved = !setup.basis.place.empty();
    const auto fits = [&](double times) { return is_moved || would_touch(path, setup, times); };
    const auto size = is_told ? std::nullopt : explain_by_unit(path, scene, unit, is_moved, fits);
    if (size) fact.evidence += "; " + *size;
  } else if (auto misfit = describe_misfit(path, result.fit)) {
    fact.basis = Basis::contradicted;
    fact.code = "path-misfit";
    fact.evidence = std::move(*misfit);
    fact.remedy = "state that it is right with --assume placement";
  } else if (!setup.basis.place.empty()) {
    fact.basis = Basis::stated;
    fact.evidence = "stated by the user";
  } else if (result.closest_approach && result.closest_approach->median_mm &&
             *result.closest_approach->median_mm <= kTouch_mm) {
    fact.basis = Basis::derived;
    fact.evidence = "half of " + positions_examined(*result.closest_approach) + " touch the part";
  } else {
    fact.evidence = "nothing states the placement of the parts, and nothing contradicts it";
  }
  return fact;
}

std::string text_in(LengthUnit unit, double length_mm) {
  return display_text(length_mm / mm_per(unit), 4) + " " + unit_name(unit);
}

/// Returns the heights of the lowest point of the tool and of the top, for a message.
std::string heights_text(LengthUnit unit, double bottom_mm, bool is_tip, const Top& top) {
  return std::string(is_tip ? "the tool" : "the lowest point of tool and heads, with offsets and tolerances,") +
         " is at height " + text_in(unit, bottom_mm) + ", not above the top of " + text_in(unit, top.height_mm) +
         (top.has_clearance ? " with its clearance" : "");
}

/// A rapid from a place that is not known is clear only above everything, with all that moves with the tool.
void settle_approaches(const Toolpath& path, const CheckSetup& setup, Assumptions& facts) {
  const auto fact = std::ranges::find(facts, Subject::completeness, &Assumption::subject);
  if (fact == facts.end() || path.approaches.empty()) return;
  const Obstructions obstructions(setup);
  const double lowest_mm = lowest_point_mm(setup);
  for (const ApproachHeight& approach : path.approaches) {
    const Top top = obstructions.top_along(approach.axis);
    const double bottom_mm = approach.height_mm + lowest_mm;
    if (bottom_mm > top.height_mm) continue;
    fact->basis = Basis::unknown;
    fact->code = "gcode-approach";
    fact->line = approach.line;
    const std::string at = std::isfinite(approach.height_mm) ? heights_text(path.unit, bottom_mm, !(lowest_mm < 0), top)
                                                             : "the height of the tool above the part is not known";
    fact->evidence = "in line " + std::to_string(approach.line) + " " + at + ", and where it comes from is not known";
    fact->remedy = std::isfinite(approach.height_mm)
                       ? "begin above everything in the program, or state that nothing is in its way with "
                         "--assume complete"
                       : "state the rotary axes before Z in the program, or that nothing is in its way with "
                         "--assume complete";
    return;
  }
}

std::size_t count_turns(const Toolpath& path) {
  std::size_t turns = 0;
  for (std::size_t i = 1; i < path.moves.size(); ++i) {
    if (!path.moves[i].has_start) continue;
    if ((path.moves[i].end.axis - path.start_of(i).axis).norm() > Tolerance::kSameDirection) ++turns;
  }
  return turns;
}

Assumption motion_law_fact(const Toolpath& path, const MotionLaw& law, const std::string& stated_by) {
  Assumption fact{.subject = Subject::motion_law, .value = law.name(), .code = "motion-law"};
  if (law.is_great_circle()) fact.value = "great circle";
  fact.file = path.file;
  fact.remedy = "state that the machine keeps to it with --assume motion-law";
  const std::size_t turns = count_turns(path);
  if (turns == 0 && !law.bends_without_turning()) {
    fact.basis = Basis::derived;
    fact.value = "fixed tool axis";
    fact.evidence = "the tool axis turns in no move";
  } else if (path.joint_law_line > 0 && law.is_great_circle()) {
    fact.basis = Basis::contradicted;
    fact.line = path.joint_law_line;
    fact.evidence = "text for the control in line " + std::to_string(path.joint_law_line) +
                    " turns the tool by its rotary joints in proportion, and not on the great circle";
    fact.remedy =
        "give --machine with --feed-law axis, or state with --assume motion-law that the axis turns on the great circle";
  } else if (!stated_by.empty()) {
    fact.basis = Basis::stated;
    fact.evidence = stated_by;
  } else if (!law.is_great_circle()) {
    fact.evidence = "the tool axis turns in " + count_text(turns, "move") + "; the control promises no law of motion";
  } else {
    fact.evidence = "the tool axis turns in " + count_text(turns, "move") +
                    "; CL data means the great circle between two positions";
  }
  return fact;
}

}  // namespace

Assumption assume_solid(const std::string& name, const MeshFindings& findings) {
  Assumption fact{.subject = Subject::solid, .object = name, .code = "mesh-not-solid"};
  fact.file = name;
  fact.remedy = "repair it with gougecheck mesh --repair, or state with --assume solid that no tool lies inside it";
  if (findings.is_solid() && findings.encloses_volume()) {
    fact.basis = Basis::derived;
    fact.value = "closed";
    fact.evidence = "closed, oriented outwards";
  } else if (findings.is_solid()) {
    fact.value = "without volume";
    fact.evidence = "the surface encloses no volume, as a sheet with a front and a back does";
    fact.remedy =
        "export the solid in place of its surface, or state with --assume solid that the part is this surface";
  } else if (findings.may_be_cut_off) {
    fact.basis = Basis::unknown;
    fact.value = "perhaps cut off";
    fact.code = "mesh-cut-off";
    fact.evidence = "the file ends without 'endsolid' and its surface bounds no solid: it may be cut off";
    fact.remedy = "export it again, or state with --assume solid that it is whole";
  } else {
    fact.value = "not closed";
    fact.evidence = "the surface does not bound a solid, so a tool wholly inside it is not found";
  }
  return fact;
}

void assess(const Toolpath& path, const CheckSetup& setup, CheckResult& result) {
  const unsigned threads = setup.options.threads;
  result.closest_approach = measure_closest_approach(path, setup.tools, setup.scene, result.verdicts, threads);
  result.fit = find_path_fit(path, result.verdicts, setup.tools, setup.scene, threads);
  Assumptions facts = path.assumptions;
  settle_approaches(path, setup, facts);
  settle_ways(path, setup, result.verdicts, facts);
  facts.push_back(motion_law_fact(path, setup.options.law, setup.basis.law_evidence));
  facts.insert(facts.end(), setup.basis.inputs.begin(), setup.basis.inputs.end());
  if (!setup.scene.workpiece().meshes.empty()) {
    facts.push_back(mesh_unit_fact(path, setup, result));
    facts.push_back(placement_fact(path, setup, result));
  }
  settle(facts, setup.basis.vouched, setup.basis.is_strict);
  result.assumptions = std::move(facts);
}

}  // namespace gouge

#include "cli/machine/machine_facts.h"

#include <algorithm>
#include <vector>

#include "cli/machine/machine_choice.h"
#include "lib/base/number_text.h"
#include "lib/base/tolerance.h"
#include "lib/base/units.h"
#include "lib/path/run_kind.h"
#include "postproc/gcode/running/program_setup.h"

namespace gouge {
namespace {

/// Names the rotary joints whose limits are not known; empty: there are none.
std::string joints_without_limits(const Machine& machine) {
  std::string names;
  for (const std::size_t k : machine.rotary) {
    const Joint& joint = machine.joints[k];
    if (joint.is_continuous || (joint.min && joint.max)) continue;
    names += (names.empty() ? "" : " and ") + joint.name;
  }
  return names;
}

Assumption kinematics_fact(const Machine& machine, const std::string& typed, const Toolpath& path) {
  Assumption fact{.subject = Subject::machine, .basis = Basis::stated, .value = machine.name, .code = "machine-law"};
  if (!typed.starts_with(kMachinePreset)) fact.file = typed;
  fact.evidence = machine.source.empty() ? "no source of the kinematics is given" : machine.source;
  if (const std::string names = joints_without_limits(machine); !names.empty())
    fact.evidence += ", the limits of joint " + names + " are not given";
  if (path.has_turned_frame && !machine.is_placed) {
    fact.basis = Basis::contradicted;
    fact.code = "machine-frame";
    fact.file = path.file;
    fact.evidence =
        "the toolpath states a frame whose X, Y and Z are turned from those of the part, and without --zero the "
        "axes of the machine are those of the part";
    fact.remedy = "give --zero with its angles, or state with --assume machine that the axes are those of the part";
  }
  return fact;
}

bool has_tolerances(const Control& control) { return control.tip_tolerance_mm > 0 || control.axis_tolerance_rad > 0; }

Assumption smoothing_fact(const Machine* machine, const MachineStatement& stated, const Toolpath& path) {
  Assumption fact{.subject = Subject::smoothing, .value = "none", .code = "control-smoothing"};
  const MotionTube& tube = stated.tube;
  if (!tube.is_empty())
    fact.value = display_text(tube.tip_mm, 6) + " mm and " + display_text(tube.axis_rad / kDegree_rad, 6) + " degrees";
  fact.remedy =
      "give --tip-tolerance and --axis-tolerance (0 for none), or state with --assume smoothing that the "
      "control keeps to its law";
  const bool is_of_machine = !stated.has_tolerances && machine != nullptr && has_tolerances(machine->control);
  const double stated_mm = is_of_machine ? machine->control.tip_tolerance_mm : tube.tip_mm;
  if ((stated.has_tolerances || is_of_machine) && path.smoothing_mm > stated_mm + Tolerance::kRounding_mm) {
    fact.basis = Basis::contradicted;
    fact.file = path.file;
    fact.line = path.smoothing_line;
    fact.evidence = "text for the control lets the tool leave the path by " + display_text(path.smoothing_mm, 6) +
                    " mm" + ", and the stated tolerance is " + display_text(stated_mm, 6) + " mm";
    fact.remedy =
        "state the larger one with --tip-tolerance, or with --assume smoothing that the control keeps to its law";
  } else if (stated.has_tolerances) {
    fact.basis = Basis::stated;
    fact.evidence = "stated by the options";
  } else if (is_of_machine) {
    fact.basis = Basis::stated;
    fact.evidence = "control " + machine->control.name + " of machine " + machine->name;
  } else if (path.smoothing_line > 0) {
    fact.basis = Basis::unknown;
    fact.file = path.file;
    fact.line = path.smoothing_line;
    fact.evidence = "text for the control in line " + std::to_string(path.smoothing_line) +
                    " lets it leave the path, and no tolerance is stated";
  } else {
    fact.evidence = "neither options nor the machine file state a tolerance of the control";
  }
  return fact;
}

/// Returns whether all linear joints run along X, Y or Z of the part.
bool runs_along_axes(const Machine& machine, const std::optional<RotaryAngles>& angles) {
  return std::ranges::all_of(machine.linear, [&](std::size_t linear) {
    Vec3 direction = machine.joints[linear].direction;
    for (std::size_t k = machine.rotary.size(); k-- > 0;) {
      if (machine.rotary[k] > linear) continue;
      if (!angles) return false;
      direction = Eigen::AngleAxisd((*angles)[k], machine.joints[machine.rotary[k]].direction) * direction;
    }
    return direction.cwiseAbs().maxCoeff() > 1 - Tolerance::kRounding;
  });
}

bool runs_along_axes(const Machine& machine, const Toolpath& path, std::size_t move) {
  if (path.joints == nullptr) return runs_along_axes(machine, std::nullopt);
  return runs_along_axes(machine, path.joints->start.at(move)) && runs_along_axes(machine, path.joints->end.at(move));
}

bool is_upright(const Toolpath& path, std::size_t move) {
  return path.moves[move].end.axis == Vec3(Vec3::UnitZ()) && path.start_of(move).axis == Vec3(Vec3::UnitZ());
}

/// Returns the moves that run in rapid from a known start.
std::vector<std::size_t> rapids_of(const Toolpath& path) {
  std::vector<std::size_t> rapids;
  for (std::size_t i = 1; i < path.moves.size(); ++i)
    if (path.moves[i].has_start && runs_rapid(path.moves[i])) rapids.push_back(i);
  return rapids;
}

/// Returns whether a move runs alike however its axes run: along one of X, Y and Z without a turn, or on a curve.
bool is_along_one_axis(const Toolpath& path, std::size_t index) {
  const Move& move = path.moves[index];
  if (move.kind != MoveKind::rapid) return true;
  const Pose& start = path.start_of(index);
  const auto axes = ((move.end.tip - start.tip).array().abs() > Tolerance::kRounding_mm).count();
  return axes <= 1 && move.end.axis == start.axis;
}

std::optional<Assumption> dogleg_fact(const Toolpath& path, const Machine* machine) {
  const std::vector<std::size_t> rapids = rapids_of(path);
  if (rapids.empty()) return std::nullopt;
  Assumption fact{.subject = Subject::motion_law, .object = "rapids", .code = "rapid-axes"};
  fact.value = "dog-legs along X, Y and Z of the part";
  fact.file = path.file;
  fact.remedy =
      "give --machine with --rapid-law independent in place of --rapid dogleg, or state with --assume "
      "motion-law=rapids that the linear axes run so";
  const auto turned = [&](std::size_t i) { return machine != nullptr && !runs_along_axes(*machine, path, i); };
  const auto open = std::ranges::find_if(rapids, turned);
  if (path.has_turned_frame) {
    fact.basis = Basis::contradicted;
    fact.evidence = "the toolpath states a frame whose X, Y and Z are turned from those of the part";
  } else if (open != rapids.end()) {
    fact.basis = Basis::contradicted;
    fact.line = path.moves[*open].line;
    fact.evidence = "in the rapid of line " + std::to_string(fact.line) + " the linear axes of machine " +
                    machine->name + " are not known to be along X, Y and Z of the part";
  } else if (machine != nullptr) {
    fact.basis = Basis::derived;
    fact.evidence = "the linear axes of machine " + machine->name + " run along X, Y and Z of the part in all rapids";
  } else if (std::ranges::all_of(rapids, [&](std::size_t i) { return is_upright(path, i); })) {
    fact.basis = Basis::derived;
    fact.evidence = "the tool axis is Z in all rapids";
  } else {
    fact.evidence = "the tool is tilted in rapids, and a table that turns would turn the axes too";
  }
  return fact;
}

}  // namespace

Assumptions machine_facts(const Machine* machine, const MachineStatement& stated, const Toolpath& path) {
  Assumptions facts;
  if (machine != nullptr) facts.push_back(kinematics_fact(*machine, stated.typed, path));
  if (machine != nullptr || path.smoothing_line > 0) facts.push_back(smoothing_fact(machine, stated, path));
  return facts;
}

std::optional<Assumption> rapid_fact(const Toolpath& path, const MotionLaw& law, const Machine* machine) {
  if (law.rapid() == RapidMode::dogleg) return dogleg_fact(path, machine);
  if (machine != nullptr || path.dialect == kProgramDialect || law.rapid() == RapidMode::skip) return std::nullopt;
  std::vector<std::size_t> rapids = rapids_of(path);
  std::erase_if(rapids, [&](std::size_t i) { return is_along_one_axis(path, i); });
  if (rapids.empty()) return std::nullopt;
  Assumption fact{.subject = Subject::motion_law, .object = "rapids", .value = "straight", .code = "rapid-axes"};
  fact.file = path.file;
  fact.line = path.moves[rapids.front()].line;
  fact.evidence =
      "several axes move in " + count_text(rapids.size(), "rapid") + ", and no file states that they run straight";
  fact.remedy = "state it with --assume motion-law=rapids, or check the other way with --rapid dogleg";
  return fact;
}

}  // namespace gouge

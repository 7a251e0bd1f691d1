#include "cli/machine/machine_facts.h"

#include "cli/machine/machine_choice.h"
#include "lib/base/number_text.h"
#include "lib/base/units.h"

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

Assumption kinematics_fact(const Machine& machine, const std::string& typed) {
  Assumption fact{.subject = Subject::machine, .basis = Basis::stated, .value = machine.name, .code = "machine-law"};
  if (!typed.starts_with(kMachinePreset)) fact.file = typed;
  fact.evidence = machine.source.empty() ? "no source of the kinematics is given" : machine.source;
  if (const std::string names = joints_without_limits(machine); !names.empty())
    fact.evidence += ", the limits of joint " + names + " are not given";
  return fact;
}

Assumption smoothing_fact(const Machine& machine, const MotionTube& tube, bool has_tolerances) {
  const Control& control = machine.control;
  const bool has_stated = has_tolerances || control.tip_tolerance_mm > 0 || control.axis_tolerance_rad > 0;
  Assumption fact{.subject = Subject::smoothing, .value = "none", .code = "control-smoothing"};
  if (!tube.is_empty())
    fact.value = display_text(tube.tip_mm, 6) + " mm and " + display_text(tube.axis_rad / kDegree_rad, 6) + " degrees";
  fact.basis = has_stated ? Basis::stated : Basis::by_default;
  fact.evidence = !has_stated      ? "neither options nor the machine file state a tolerance of the control"
                  : has_tolerances ? "stated by the options"
                                   : "control " + control.name + " of machine " + machine.name;
  fact.remedy =
      "give --tip-tolerance and --axis-tolerance (0 for none), or state with --assume smoothing that the "
      "control keeps to its law";
  return fact;
}

}  // namespace

Assumptions machine_facts(const Machine& machine, const std::string& typed, const MotionTube& tube,
                          bool has_tolerances) {
  return {kinematics_fact(machine, typed), smoothing_fact(machine, tube, has_tolerances)};
}

}  // namespace gouge

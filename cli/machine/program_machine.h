#pragma once

#include <memory>
#include <optional>

#include "cli/machine/machine_choice.h"
#include "postproc/gcode/running/program_setup.h"

namespace gouge {

/// Returns a tolerance of a control or of an option; none: 0, which states none.
[[nodiscard]] inline std::optional<double> stated_tolerance(double value) {
  return value > 0 ? std::optional(value) : std::nullopt;
}

/// Returns the set-up of a program with the facts of a machine: its joints, its control and the blocks in force at the
/// start. What the set-up states already stays. `laws`: of the check; none: those of the control. `stated`: as of
/// load_machine.
[[nodiscard]] std::shared_ptr<const ProgramSetup> with_machine(const std::shared_ptr<const ProgramSetup>& setup,
                                                               const Machine& machine, const StatedMachine& stated,
                                                               const std::optional<TurnLaws>& laws,
                                                               const std::optional<double>& tip_tolerance_mm,
                                                               const std::optional<double>& axis_tolerance_rad);

/// Facts that options state about a control whose machine is not given. None: not stated.
struct ControlFacts {
  std::optional<TurnLaw> joint_rapid_law{};
  std::optional<double> tool_length_mm{}, tip_tolerance_mm{}, axis_tolerance_rad{};
};

/// Returns the set-up of a program with the facts of its control, without a machine.
[[nodiscard]] std::shared_ptr<const ProgramSetup> with_control(const std::shared_ptr<const ProgramSetup>& setup,
                                                               const ControlFacts& facts);

/// Returns the error of a program that cut the stock before a path, if its coordinates are those of another work offset. None:
/// they are not, or one of both is no program of a control.
[[nodiscard]] std::optional<Diagnostic> find_other_offset(const Toolpath& before, const Toolpath& path);

}  // namespace gouge

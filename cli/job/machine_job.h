#pragma once

#include "cli/options/job_options.h"
#include "lib/machine/joint_path.h"
#include "lib/motion/motion_law.h"

namespace gouge {

/// Returns the law of motion on a machine: as --feed-law and --rapid-law state, else as its control promises.
/// Error: machine-law, where neither states one.
[[nodiscard]] Result<MotionLaw> law_of(const Machine& machine, const JobArguments& arguments, RapidMode rapid);

/// Returns who states the laws: options, and the control with its source.
[[nodiscard]] std::string describe_law(const Machine& machine, const JobArguments& arguments);

/// Chooses the joints of a path and stores them with it. Moves that the machine cannot run are not checked, with their
/// reason. Returns a warning for each problem, at most twenty.
[[nodiscard]] Diagnostics choose_joints_of(const Machine& machine, Toolpath& path);

/// Describes a problem, as a warning with its line.
[[nodiscard]] Diagnostic describe_problem(const Machine& machine, const Toolpath& path, const JointProblem& problem);

}  // namespace gouge

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lib/machine/machine.h"

namespace gouge {

/// Facts of joints that the user states in place of those of the machine file, as typed.
struct StatedJoints {
  std::vector<std::string> limits;  ///< "A=0..120", "A=..120", "A=0..", "A=free": degrees, of a linear joint mm
  std::vector<std::string> points;  ///< "A=0,0,50": a point on the axis of a rotary joint, mm
  std::vector<std::string> rates;   ///< "A=3600": degrees or mm per minute
};

/// Names of these options in messages: those of the command line, or others.
struct JointOptionNames {
  std::string limit = "--joint-limit", point = "--joint-point", rate = "--joint-rate";
};

/// Replaces facts of joints by those that the user states. A side that a limit leaves out has no limit then.
/// Returns the first error (code usage). It is a text of another form, a joint that the machine does not have, or one
/// that is stated twice. Or it is a point of a linear joint, a linear joint without limits, or a rate of 0.
[[nodiscard]] std::optional<Diagnostic> state_joints(const StatedJoints& stated, const JointOptionNames& names,
                                                     Machine& machine);

/// Returns the options of `stated` as typed, each with its name: "--joint-limit A=0..120".
[[nodiscard]] std::vector<std::string> stated_texts(const StatedJoints& stated, const JointOptionNames& names);

}  // namespace gouge

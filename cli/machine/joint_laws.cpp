#include "cli/machine/joint_laws.h"

#include <algorithm>
#include <memory>

#include "lib/machine/joint_law.h"
#include "lib/machine/tip_slack.h"

namespace gouge {
namespace {

JointTiming timing_of(const std::optional<TurnLaw>& law) {
  if (!law) return JointTiming::unknown;
  return *law == TurnLaw::independent ? JointTiming::independent : JointTiming::together;
}

}  // namespace

std::optional<Diagnostic> add_joint_laws(const Machine& machine, const TurnLaws& laws,
                                         const std::optional<double>& tool_length_mm, double tool_length_slack_mm,
                                         const Toolpath& path, MotionLaw& law) {
  if (std::ranges::none_of(path.moves, [](const Move& move) { return move.runs_joints; })) return std::nullopt;
  const std::optional<double> slack_mm = tip_slack_mm(machine, {TurnLaw::joint, TurnLaw::joint}, tool_length_slack_mm);
  if (!slack_mm || *slack_mm > 0)
    return make_error("machine-law",
                      "the program has moves without tool centre point control, and these need exact points of rotary "
                      "joints and an exact tool length; expected single values in place of intervals on machine " +
                          machine.name,
                      path.file);
  law.set_joint_axes(std::make_shared<const JointLaw>(machine, JointTiming::together, tool_length_mm),
                     std::make_shared<const JointLaw>(machine, timing_of(laws.joint_rapids), tool_length_mm));
  return std::nullopt;
}

}  // namespace gouge

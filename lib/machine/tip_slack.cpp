#include "lib/machine/tip_slack.h"

#include <Eigen/SVD>
#include <cmath>

#include "lib/base/tolerance.h"
#include "lib/machine/law_facts.h"

namespace gouge {
namespace {

bool are_neighbours(const Machine& machine) {
  return machine.linear[1] == machine.linear[0] + 1 && machine.linear[2] == machine.linear[1] + 1;
}

/// Returns the ratio of the largest to the smallest length to which the linear joints map a unit vector.
double condition_of(const Machine& machine) {
  Eigen::Matrix3d directions;
  for (int k = 0; k < 3; ++k) directions.col(k) = machine.joints[machine.linear[static_cast<std::size_t>(k)]].direction;
  const Vec3 values = Eigen::JacobiSVD<Eigen::Matrix3d>(directions).singularValues();
  return values[0] / values[2];
}

}  // namespace

std::optional<double> tip_slack_mm(const Machine& machine, const TurnLaws& laws, double tool_length_slack_mm) {
  double slack_mm = tool_length_slack_mm;
  for (const std::size_t k : machine.rotary) slack_mm += 2 * machine.joints[k].point_slack_mm;
  if (!(slack_mm > 0)) return 0.0;
  double times = 1;
  if (runs_joints(laws.feeds) || runs_joints(laws.rapids)) {
    if (!are_neighbours(machine)) return std::nullopt;
    const bool is_apart = laws.feeds == TurnLaw::independent || laws.rapids == TurnLaw::independent;
    times = 1 + (is_apart ? std::sqrt(2.0) : 1) * condition_of(machine);
  }
  return times * slack_mm * (1 + Tolerance::kRounding);
}

}  // namespace gouge

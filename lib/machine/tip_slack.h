#pragma once

#include <optional>

#include "lib/machine/machine.h"

namespace gouge {

/// Returns how far the tip can be from its place by the laws, mm, if the places of rotary axes and the tool length are
/// anywhere in their intervals. The laws use the middles. The control uses the middles or the true values. The result is
/// 0 without intervals, and none if it is not bounded: a linear joint is not beside the other ones in the chain.
/// Proof: docs/method/machine.md, "Intervals".
[[nodiscard]] std::optional<double> tip_slack_mm(const Machine& machine, const TurnLaws& laws,
                                                 double tool_length_slack_mm);

}  // namespace gouge

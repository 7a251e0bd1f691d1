#pragma once

#include <array>
#include <optional>
#include <vector>

namespace gouge {

/// Angles of the two rotary joints of a machine in rad; the joint nearer to the part comes first.
using RotaryAngles = std::array<double, 2>;

/// Shares of the ways of both rotary joints in a move, each in [0, 1]; the joint nearer to the part comes first.
using TurnShares = std::array<double, 2>;

/// Rotary angles over a path: one entry for each move, at its start and at its end; none if they are not known.
struct JointPath {
  std::vector<std::optional<RotaryAngles>> start, end;
};

}  // namespace gouge

#pragma once

#include <array>
#include <optional>
#include <vector>

namespace gouge {

/// Angles of the two rotary joints of a machine, that nearer to the part first, rad.
using RotaryAngles = std::array<double, 2>;

/// Rotary angles over a path: one entry a move, at its start and at its end. None where they are not known.
struct JointPath {
  std::vector<std::optional<RotaryAngles>> start, end;
};

}  // namespace gouge

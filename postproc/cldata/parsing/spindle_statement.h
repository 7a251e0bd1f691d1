#pragma once

#include <optional>
#include <span>

#include "postproc/cldata/language/arguments.h"

namespace gouge {

/// Returns the speed that SPINDL/.. states, in revolutions per minute: the number beside RPM, else the first one. It is 0
/// for OFF and for a speed along the surface (SFM, SMM); none: the statement keeps the speed, such as SPINDL/ON.
[[nodiscard]] std::optional<float> read_spindle_speed(std::span<const Argument> arguments);

/// Returns whether SPINDL/.. stops the spindle: true for OFF, a speed of 0 and a stop at an angle, false for ON, a sense
/// or a speed. None: it does neither, such as SPINDL/MAXRPM,6000.
[[nodiscard]] std::optional<bool> stops_spindle(std::span<const Argument> arguments);

}  // namespace gouge

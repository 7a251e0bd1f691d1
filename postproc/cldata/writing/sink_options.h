#pragma once

#include <string>

#include "lib/base/units.h"
#include "postproc/cldata/language/dialect.h"

namespace gouge {

/// Facts about the toolpath that a sink needs before its first motion.
struct SinkOptions {
  Dialect dialect;
  LengthUnit unit = LengthUnit::mm;
  int decimals = 0, axis_decimals = 0;  ///< no fewer than these
  bool is_tilted = false;               ///< an axis of the path is not +Z
  bool is_on_centre = true;             ///< all positions are the cutter's centre
  std::string name;                     ///< of the part program
};

}  // namespace gouge

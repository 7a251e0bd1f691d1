#pragma once

#include <string>

#include "lib/base/units.h"
#include "postproc/cldata/language/dialect.h"

namespace gouge {

/// Facts about the toolpath that a sink needs before its first motion.
struct SinkOptions {
  Dialect dialect;
  LengthUnit unit = LengthUnit::mm;
  int decimals = 0, axis_decimals = 0;  ///< minimum numbers of decimals
  bool is_tilted = false;               ///< whether an axis of the path differs from +Z
  bool is_on_centre = true;             ///< whether all positions are those of the cutter's centre
  std::string name;                     ///< name of the part program
};

}  // namespace gouge

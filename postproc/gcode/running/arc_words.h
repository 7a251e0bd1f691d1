#pragma once

#include <array>
#include <optional>
#include <string>

#include "postproc/gcode/running/program_motion.h"

namespace gouge {

/// Axes of a plane: the first and the second turn counterclockwise about the third.
using PlaneAxes = std::array<int, 3>;

/// Words of a block about an arc, besides its end; mm.
struct ArcWords {
  PlaneAxes plane{0, 1, 2};
  bool is_clockwise = false;  ///< seen against the third axis of the plane
  std::optional<double> radius_mm;
  std::array<std::optional<double>, 3> centre_mm;  ///< I, J and K
  bool is_centre_absolute = false;
  int turns = 1;  ///< a full circle more for each turn above 1
};

struct ArcReading {
  ProgramArc arc;
  std::string open;  ///< why the arc is not known; empty: it is
};

/// Returns the arc from `start` to `end`. An arc whose end is its start is a full circle, with I, J and K only.
/// Source   LinuxCNC, G-Code Reference, G2 G3; src/emc/rs274ngc/interp_arc.cc: tolerance of the radius. Fanuc B-64484EN,
///          circular interpolation.
[[nodiscard]] ArcReading read_program_arc(const ArcWords& statement, const Vec3& start, const Vec3& end);

}  // namespace gouge

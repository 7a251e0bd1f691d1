#pragma once

#include "lib/geom/vec.h"

namespace gouge {

/// Where the tool is: its tip, and its unit axis from the tip to the spindle. Part coordinates, mm.
struct Pose {
  Vec3 tip = Vec3::Zero();
  Vec3 axis = Vec3::UnitZ();
};

}  // namespace gouge

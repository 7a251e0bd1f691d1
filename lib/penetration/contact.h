#pragma once

#include <cstdint>

#include "lib/geom/vec.h"

namespace gouge {

/// A point at which two solids penetrate each other. Both modules that correct positions use it.
struct Contact {
  Vec3 point = Vec3::Zero();    ///< a point of one body, inside the other; mm, part coordinates
  Vec3 normal = Vec3::UnitZ();  ///< unit direction of the shortest way out of the other body
  double depth_mm = 0;          ///< length of that way
  std::uint32_t body = 0;       ///< index of the moving body, chosen by the caller
  std::uint32_t triangle = 0;   ///< nearest triangle of the other body, by its number in the file
};

}  // namespace gouge

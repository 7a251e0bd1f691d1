#pragma once

#include <cstdint>

#include "lib/geom/vec.h"

namespace gouge {

/// One point where two solids run into each other: the currency of both cores.
struct Contact {
  Vec3 point = Vec3::Zero();    ///< of the one body, inside the other; mm, part coordinates
  Vec3 normal = Vec3::UnitZ();  ///< unit; the shortest way out of the other body
  double depth_mm = 0;          ///< how far that is
  std::uint32_t body = 0;       ///< which moving body, by the caller's count
  std::uint32_t triangle = 0;   ///< nearest triangle of the other body, by its number in the file
};

}  // namespace gouge

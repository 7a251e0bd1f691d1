#pragma once

#include <vector>

#include "lib/field/checked_toolpath.h"

// What the directions of views are chosen by: no picture need be drawn to know what it would show.

namespace gouge {

/// The deepest point of a gouging move.
struct GougeWitness {
  Vec3 at = Vec3::Zero();
  Vec3 normal = Vec3::UnitZ();  ///< unit, out of the tool's depth
  double weight = 0;            ///< about the area of what the move gouges, in no unit
};

/// Those of a path, in its order; of more than `most` every so manieth.
[[nodiscard]] std::vector<GougeWitness> gouge_witnesses(const CheckedToolpath& input, std::size_t most);

/// Whether nothing of parts and fixtures lies between the point and a viewer far away in direction `toward` (unit),
/// farther than `clear_mm` from the point. Cost: about O(log n).
[[nodiscard]] bool is_in_sight(const CheckedToolpath& input, const Vec3& point, const Vec3& toward, double clear_mm);

}  // namespace gouge

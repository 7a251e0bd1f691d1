#pragma once

#include <cstddef>
#include <vector>

#include "lib/machine/machine.h"
#include "lib/path/toolpath.h"

namespace gouge {

/// A start from which a rotary joint cannot make the turns that are chosen for a path.
struct OtherStart {
  std::size_t joint = 0;  ///< of Machine::joints
  double chosen_rad = 0;  ///< its angle at the first position
  double other_rad = 0;   ///< the same angle, whole turns away; within the limits too
  std::size_t move = 0;   ///< the first move that passes a limit from there
};

/// Returns a start for each rotary joint that has one: the control may begin there, and then turns otherwise than the path
/// is checked. Requires Toolpath::joints. Cost O(moves).
[[nodiscard]] std::vector<OtherStart> find_other_starts(const Machine& machine, const Toolpath& path);

}  // namespace gouge

#pragma once

#include <vector>

#include "lib/path/toolpath.h"

namespace gouge {

/// Returns the unit axis at `t`, from 0 to 1, of an even turn on the great circle from one unit axis to another. At 1
/// it is exactly `to`. For opposite axes the great circle is undefined; then it is `from` until t = 1.
[[nodiscard]] Vec3 axis_between(const Vec3& from, const Vec3& to, double t);

/// Returns positions along the move `index`, which is on an arc or a spline; the last one is its end. Straight moves
/// from its start through them stay within `error_mm` of it. The axis turns evenly on the great circle. Requires a
/// curve and a start. Cost: at most about 10000 positions for each piece or turn.
[[nodiscard]] std::vector<Pose> chords_of(const Toolpath& path, std::size_t index, double error_mm);

}  // namespace gouge

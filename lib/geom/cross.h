#pragma once

#include "lib/geom/vec.h"

namespace gouge {

/// Positive where `v` is to the left of `u`.
[[nodiscard]] inline double cross(const Vec2& u, const Vec2& v) { return u.x() * v.y() - u.y() * v.x(); }

}  // namespace gouge

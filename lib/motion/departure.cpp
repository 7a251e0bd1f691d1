#include "lib/motion/departure.h"

#include <numbers>

#include "lib/base/tolerance.h"

namespace gouge {

namespace {

// An arc of the unit circle is longer than its chord by at most this factor, for any two directions.
constexpr double kArcOfChord = std::numbers::pi / 2;

/// Bounds how far the axis is from the straight chord between its ends, at a constant rate along it.
double axis_sag(const Motion& motion) { return motion.rates(0, 1, 0).axis_acceleration_rad() / 8; }

}  // namespace

Departure departure_of(const Motion& motion) {
  if (motion.is_alone()) return {};
  // Both motions have the same ends, and the same tip at every instant.
  if (const std::optional<Motion> other = motion.other()) {
    const double sags = axis_sag(motion) + axis_sag(*other);
    return {0, sags > 0 ? kArcOfChord * sags + Tolerance::kExactDirection : 0};
  }
  // Every pose is within the spread from the middle of the box of all shares.
  if (motion.is_any()) return {0, 2 * motion.axis_path()->spread({0, 0}, {1, 1}).axis_rad};
  return {};
}

}  // namespace gouge

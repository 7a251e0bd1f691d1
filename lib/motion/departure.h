#pragma once

#include "lib/motion/motion.h"

namespace gouge {

/// Bounds how far a tool may be from the motion that stands for its move, at the same instant.
struct Departure {
  double tip_mm = 0;
  double axis_rad = 0;

  [[nodiscard]] bool is_none() const { return !(tip_mm > 0) && !(axis_rad > 0); }
  /// Bounds the departure of the points of a solid of revolution about the tool axis that are at most `reach_mm` from the
  /// tip. The smallest turn from one axis to the other moves them by no more.
  [[nodiscard]] double at_mm(double reach_mm) const { return tip_mm + axis_rad * reach_mm; }
  [[nodiscard]] Departure operator+(const Departure& other) const {
    return {tip_mm + other.tip_mm, axis_rad + other.axis_rad};
  }
};

/// Returns the departure of all motions that the law admits for a move from the given one, its first; none where it admits
/// this one alone. Requires motion.is_defined(). Proof: docs/method/stock.md, section "Motions that are known in part".
[[nodiscard]] Departure departure_of(const Motion& motion);

}  // namespace gouge

#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "lib/tilt/tilt_space.h"

namespace gouge {

/// Tilts that may be chosen at one position of a run.
struct TiltLayer {
  double way_mm = 0;  ///< TiltPosition::way_mm
  std::vector<Tilt> tilts;
  /// Those of it that may not be followed by these of the next layer, by their indices; sorted.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> struck;
  /// Nor may any that is farther away.
  double largest_change_rad = std::numeric_limits<double>::infinity();
};

/// Positions that are closer count as so far apart.
inline constexpr double kLeastWay_mm = 1e-3;

/// One tilt of each layer such that sum of |tilt|^2 ds / blend^2 + |change of tilt|^2 / ds is least; nothing where no
/// choice is left. Of choices as cheap the one with the first tilts in the last layers.
///
/// Requires layers in the order of the way, at least one.
/// Cost     the sum of the products of the sizes of neighbouring layers, about 1 ns each.
/// Source   dynamic programming over layers of postures: Plakhotnik and Lauwers 2014.
[[nodiscard]] std::optional<std::vector<std::uint32_t>> cheapest_choice(const std::vector<TiltLayer>& layers,
                                                                        double blend_mm);

}  // namespace gouge

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
  double arc_length_mm = 0;  ///< TiltPosition::arc_length_mm
  std::vector<Tilt> tilts;
  /// Those of it that may not be followed by these of the next layer, by their indices; sorted.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> struck;
  /// Nor may any that is farther away.
  double largest_change_rad = std::numeric_limits<double>::infinity();
};

/// Positions that are closer count as so far apart.
inline constexpr double kMinWay_mm = 1e-3;

/// The choices of one tilt of each layer.
struct LayerChoices {
  std::optional<std::vector<std::uint32_t>> cheapest;  ///< none where there is no choice
  std::size_t first_unreached = 0;                     ///< then: the first layer that none leads to
  /// For each layer's tilts: whether any choice takes it. May be true of a tilt that only removed changes forbid.
  /// Where there is no choice: whether any leads to it.
  std::vector<std::vector<char>> is_possible;
};

/// Finds the choice for which sum of |tilt|^2 ds / blend^2 + |change of tilt|^2 / ds is least. Of choices as cheap it
/// takes the one with the first tilts in the last layers, where tilts are at one place.
///
/// Requires layers in the order of the way, at least one.
/// Cost     Linear in the tilts and the rows times columns that they lie in, 0.2 ms a layer for 1,800 of a lattice.
///          Where a limit or a change struck out forbids the cheapest way to a tilt, all that may lead there are
///          tested.
/// Source   Dynamic programming over layers of postures: Plakhotnik and Lauwers 2014.
[[nodiscard]] LayerChoices cheapest_choice(const std::vector<TiltLayer>& layers, double blend_mm);

}  // namespace gouge

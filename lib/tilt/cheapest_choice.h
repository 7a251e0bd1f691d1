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
  /// Pairs (tilt of this layer, tilt of the next layer), as indices, that may not follow one another; sorted.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> struck;
  /// Maximum change of tilt to the next layer. Pairs with a larger change may not follow one another.
  double largest_change_rad = std::numeric_limits<double>::infinity();
};

/// Minimum distance of neighbouring positions in costs. Smaller distances count as this one.
inline constexpr double kMinWay_mm = 1e-3;

/// A choice of one tilt in each layer, and the tilts that choices can use.
struct LayerChoices {
  std::optional<std::vector<std::uint32_t>> cheapest;  ///< none if there is no choice
  std::size_t first_unreached = 0;                     ///< without a choice: the first layer that no sequence of tilts
                                                       ///< reaches
  /// For each layer, whether any choice uses a tilt. It may be true for a tilt that only forbidden changes exclude.
  /// Without a choice: whether any sequence of tilts reaches it.
  std::vector<std::vector<char>> is_possible;
};

/// Finds the choice with the minimum sum of |tilt|^2 ds / blend^2 + |change of tilt|^2 / ds. Of equally cheap choices
/// that differ in tilts at one place, it takes the one with the first tilts in the last layers.
///
/// Requires at least one layer, and layers in the order of the path.
/// Cost     Linear in the number of tilts and in the rows times columns in which they lie; 0.2 ms a layer for 1,800
///          tilts of a lattice. If a limit or a forbidden change excludes the cheapest predecessor of a tilt, all
///          predecessors are tested.
/// Source   Dynamic programming over layers of postures: Plakhotnik and Lauwers 2014.
[[nodiscard]] LayerChoices cheapest_choice(const std::vector<TiltLayer>& layers, double blend_mm);

}  // namespace gouge

#pragma once

#include <cstdint>
#include <span>

#include "lib/surface/surface.h"

namespace gouge {

/// Not below the distance to the surface of any point of the convex hull of `points`, of which there are at
/// most kMostHullPoints: the distance to a facet is convex, so its largest value over the hull is at one of
/// the points; so is that of any weighted mean of such distances, and the distance to the surface is no
/// larger than that mean.
///
/// `facets`: those to use, at least one; those nearest to the points are the best choice.
/// Ensures  exact (up to rounding) where the hull lies over one facet, or between two that oppose each other.
inline constexpr std::size_t kMostHullPoints = 8;
[[nodiscard]] double greatest_distance_mm(const Surface& surface, std::span<const Vec3> points,
                                          std::span<const std::uint32_t> facets);

}  // namespace gouge

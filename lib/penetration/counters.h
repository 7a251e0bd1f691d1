#pragma once

#include <cstdint>

namespace gouge {

/// What a query cost, in numbers that are the same on every machine (thesis 5.4, tables 6.a to 6.c).
struct PenetrationCounters {
  std::uint64_t volume_pairs = 0;         ///< N_b: overlap tests of two volumes
  std::uint64_t primitive_pairs = 0;      ///< N_n: points tested against facets
  std::uint64_t exact_pairs = 0;          ///< of them, those whose distance was computed
  std::uint64_t volumes_updated = 0;      ///< moving volumes brought to the pose
  std::uint64_t corners_transformed = 0;  ///< corner vertices of these volumes
  std::uint64_t volumes_shifted = 0;      ///< of the updated volumes, those whose intervals were only shifted
  std::uint64_t points_transformed = 0;
  std::uint64_t false_positives = 0;  ///< points within a facet's reach that are not inside
  std::uint64_t inside_tests = 0;     ///< searches that decided whether something far from the surface is inside
  std::uint32_t static_level = 0, moving_level = 0;  ///< deepest levels of both trees reached
};

}  // namespace gouge

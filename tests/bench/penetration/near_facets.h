#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "tests/bench/penetration/facet_planes.h"

namespace gouge {

struct DepthBody;

/// For cells of the body's grid: the facets one of which is the nearest of all to any point of the cell, on
/// either side of the surface. A point then needs no search, only these distances.
///
/// A facet is the nearest to a point of a cell only if it is no farther from the cell's centre than the
/// nearest one and the cell's diagonal together. Cells are halved twice to make that sharp.
class NearFacets {
 public:
  struct Known {
    std::span<const std::uint32_t> facets;  ///< for planes() and slot(), those nearest to the cell's centre first
    bool is_complete = false;  ///< else the facets are too many, and only the one nearest to the centre is reported
  };

  static constexpr std::uint32_t kIsComplete = 1U << 31;

  NearFacets() = default;
  /// For cells that may hold inside points no deeper than twice the depth, and their surroundings.
  /// Requires body.depths, body.boxes and body.discs. Cost about 1 microsecond a cell.
  explicit NearFacets(const DepthBody& body);

  /// No facets: nothing is known of this cell.
  [[nodiscard]] Known at(std::size_t cell) const {
    if (first_.empty() || first_[cell] == 0) return {};
    const std::uint32_t* const entry = lists_.data() + first_[cell];
    const bool is_complete = (*entry & kIsComplete) != 0;
    return {{entry + 1, *entry & ~kIsComplete}, is_complete};
  }

  [[nodiscard]] const FacetPlanes& planes(std::uint32_t facet) const { return planes_[facet]; }
  [[nodiscard]] std::uint32_t slot(std::uint32_t facet) const { return slots_[facet]; }

  /// Brings what `at` will read nearer to the processor.
  void prefetch(std::size_t cell) const {
    if (!first_.empty()) __builtin_prefetch(first_.data() + cell);
  }
  void prefetch_list(std::size_t cell) const {
    if (!first_.empty()) __builtin_prefetch(lists_.data() + first_[cell]);
  }
  void prefetch_facet(std::size_t cell) const {
    const Known known = at(cell);
    if (known.facets.empty()) return;
    const auto* const planes = reinterpret_cast<const char*>(planes_.data() + known.facets[0]);
    __builtin_prefetch(planes);
    __builtin_prefetch(planes + sizeof(FacetPlanes) / 2);
    __builtin_prefetch(slots_.data() + known.facets[0]);
  }

 private:
  void number_facets(const DepthBody& body);

  std::vector<std::uint32_t> first_;  ///< by cell, slot in lists_
  std::vector<std::uint32_t> lists_;  ///< count, with kIsComplete, then the facets
  std::vector<FacetPlanes> planes_;   ///< of the facets that stand in a list
  std::vector<std::uint32_t> slots_;  ///< of the same, in the body's tree
};

}  // namespace gouge

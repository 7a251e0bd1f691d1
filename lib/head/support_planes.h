#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>

#include "lib/surface/surface.h"

namespace gouge {

/// A plane with the whole head below it: no point has a larger normal . x than `height_mm`. Unit normal, in the tool's
/// frame.
struct OuterPlane {
  Vec3 normal = Vec3::UnitZ();
  double height_mm = 0;
};

/// The planes of a head's facets, as bounds of the whole head. For each it states how far the head rises above it,
/// computed at the first request. The object is small and shared by its copies. Any number of threads may call it.
///
/// Let n be the facet's unit normal out of the head and v a corner of it. The depth of a point q in the head is at most
/// n . (v - q) + rise, or 0 if that is negative. Moved along n by that length, q is on or above a plane with the whole
/// head below it, so it is outside. On a convex head this holds for every facet's plane; on other heads for those of
/// the convex hull.
class SupportPlanes {
 public:
  SupportPlanes() = default;
  /// Prepares the planes. The surface is shared.
  explicit SupportPlanes(const Surface& surface);

  /// Returns a height above the plane that no point of the head exceeds; infinite if the head rises by more than
  /// kMaxRise_mm.
  /// Cost     The first call for a facet searches the head's tree.
  [[nodiscard]] double rise_mm(std::uint32_t facet) const;

  /// Returns the facet's plane, raised by rise_mm; nothing if that is infinite.
  [[nodiscard]] std::optional<OuterPlane> plane(std::uint32_t facet) const;

  static constexpr double kMaxRise_mm = 1e-3;

 private:
  [[nodiscard]] double find_rise_mm(std::uint32_t facet) const;

  std::shared_ptr<const Surface> surface_;
  std::shared_ptr<std::atomic<float>[]> rises_mm_;  // by facet; NaN: not yet found
};

}  // namespace gouge

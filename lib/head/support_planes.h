#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>

#include "lib/surface/surface.h"

namespace gouge {

/// No point of a head is above it: none has a larger normal . x than `height_mm`. Unit normal, tool's frame.
struct OuterPlane {
  Vec3 normal = Vec3::UnitZ();
  double height_mm = 0;
};

/// The planes of a head's facets as bounds of all of it: how far the head rises above each, computed at the first
/// request. Small, and shared by its copies. Any number of threads may call it.
///
/// Let n be the facet's unit normal out of the head and v a corner of it. No point q is deeper in the head than n . (v
/// - q) + rise, or 0 where that is negative. Moved as far along n, q is on or above a plane that no part of the head is
/// above, so it is outside. On a convex head every facet's plane bounds so; on others those of its convex hull.
class SupportPlanes {
 public:
  SupportPlanes() = default;
  /// The surface is shared.
  explicit SupportPlanes(const Surface& surface);

  /// Returns a height above the plane that no point of the head is above; infinite where it rises above it by more than
  /// kMaxRise_mm.
  /// Cost     Of the first call for a facet a search of the head's tree.
  [[nodiscard]] double rise_mm(std::uint32_t facet) const;

  /// Returns the facet's plane, raised by that; nothing where that is infinite.
  [[nodiscard]] std::optional<OuterPlane> plane(std::uint32_t facet) const;

  static constexpr double kMaxRise_mm = 1e-3;

 private:
  [[nodiscard]] double find_rise_mm(std::uint32_t facet) const;

  std::shared_ptr<const Surface> surface_;
  std::shared_ptr<std::atomic<float>[]> rises_mm_;  // by facet; no number: not yet found
};

}  // namespace gouge

#pragma once

#include <memory>
#include <utility>

#include "lib/clash/local_maximum.h"
#include "lib/surface/surface.h"

namespace gouge {

/// One of two bodies whose overlap is looked for: its surface, and what of it only the search for a depth needs.
class ClashBody {
 public:
  /// `is_self_crossing`: triangles of the surface cross or overlap one another (lib/validate finds out). The
  /// nearest facet does not show the side then; the winding number does.
  explicit ClashBody(Surface surface, bool is_self_crossing = false)
      : surface_(std::move(surface)), is_self_crossing_(is_self_crossing) {}

  [[nodiscard]] const Surface& surface() const { return surface_; }
  [[nodiscard]] bool is_self_crossing() const { return is_self_crossing_; }
  [[nodiscard]] bool is_solid() const { return surface_.is_solid(); }

  /// Made when first asked for, by one thread. Requires is_solid() and not is_self_crossing().
  [[nodiscard]] const LocalMaxima& maxima() const {
    if (!maxima_) maxima_ = std::make_unique<LocalMaxima>(surface_);
    return *maxima_;
  }

  /// The nearest point of the surface, with the side. Requires triangles.
  [[nodiscard]] ClosestPoint closest_point(const Vec3& point) const;

 private:
  Surface surface_;
  bool is_self_crossing_;
  mutable std::unique_ptr<LocalMaxima> maxima_;
};

}  // namespace gouge

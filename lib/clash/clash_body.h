#pragma once

#include <memory>
#include <utility>

#include "lib/clash/local_maximum.h"
#include "lib/surface/surface.h"

namespace gouge {

/// One of two bodies that may overlap: its surface, and data that only the search for a depth needs.
class ClashBody {
 public:
  explicit ClashBody(Surface surface) : whole_(std::move(surface)) {}

  /// Returns the surface of all triangles of the file.
  [[nodiscard]] const Surface& whole() const { return whole_; }
  /// Returns the outer boundary of the body; sides and depths refer to it. It is made when it is first requested.
  [[nodiscard]] const Surface& boundary() const { return whole_.boundary(); }
  [[nodiscard]] bool is_solid() const { return boundary().is_solid(); }

  /// Returns the local maxima. They are made when first requested, by one thread. Requires is_solid().
  [[nodiscard]] const LocalMaxima& maxima() const {
    if (!maxima_) maxima_ = std::make_unique<LocalMaxima>(boundary());
    return *maxima_;
  }

  /// Returns the nearest point of the boundary, and on which side of it `point` lies. Requires triangles.
  [[nodiscard]] ClosestPoint closest_point(const Vec3& point) const { return *boundary().closest_point(point); }

 private:
  Surface whole_;
  mutable std::unique_ptr<LocalMaxima> maxima_;
};

}  // namespace gouge

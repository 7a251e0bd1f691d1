#include "lib/head/support_planes.h"

#include <cmath>
#include <limits>

#include "lib/hierarchy/triangles_within.h"

namespace gouge {
namespace {

constexpr double kRiseRounding_mm = 1e-8;  // error of a search of the tree, and rounding to single precision

}  // namespace

SupportPlanes::SupportPlanes(const Surface& surface) : surface_(std::make_shared<const Surface>(surface)) {
  const std::size_t count = surface.mesh().triangles.size();
  rises_mm_ = std::shared_ptr<std::atomic<float>[]>(new std::atomic<float>[count]);
  for (std::size_t t = 0; t < count; ++t)
    rises_mm_[static_cast<std::ptrdiff_t>(t)].store(std::numeric_limits<float>::quiet_NaN(), std::memory_order_relaxed);
}

// Returns the stored rise or finds it. Concurrent calls find the same value.
double SupportPlanes::rise_mm(std::uint32_t facet) const {
  std::atomic<float>& known = rises_mm_[static_cast<std::ptrdiff_t>(facet)];
  const float rise = known.load(std::memory_order_relaxed);
  if (!std::isnan(rise)) return static_cast<double>(rise);
  const auto found = static_cast<float>(find_rise_mm(facet));
  known.store(found, std::memory_order_relaxed);
  return static_cast<double>(found);
}

std::optional<OuterPlane> SupportPlanes::plane(std::uint32_t facet) const {
  const double rise = rise_mm(facet);
  if (!std::isfinite(rise)) return std::nullopt;
  const Vec3 n = surface_->face_normal(facet);
  return OuterPlane{n, n.dot(surface_->mesh().corner(facet, 0)) + rise};
}

double SupportPlanes::find_rise_mm(std::uint32_t facet) const {
  const Vec3 n = surface_->face_normal(facet);
  if (!(n.squaredNorm() > 0.5)) return std::numeric_limits<double>::infinity();  // the facet has no area
  const double at_mm = n.dot(surface_->mesh().corner(facet, 0));
  const double highest_mm = highest_along(surface_->tree(), n, at_mm, at_mm + kMaxRise_mm);
  return highest_mm - at_mm + kRiseRounding_mm;
}

}  // namespace gouge

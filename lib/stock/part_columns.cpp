#include "lib/stock/part_columns.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "lib/base/tolerance.h"
#include "lib/geom/point_triangle.h"
#include "lib/hierarchy/triangles_within.h"

namespace gouge {

namespace {

// Sides of a prism are moved in by this much, so that facets that only touch it do not enter it.
constexpr double kInset_mm = 2 * Tolerance::kRounding_mm;

}  // namespace

Result<PartColumns> PartColumns::of(std::span<const Surface> parts) {
  PartColumns columns;
  for (const Surface& surface : parts) {
    if (!surface.is_solid() || !surface.boundary().is_solid()) {
      return make_error(
          "excess-open-part",
          "the part is no closed mesh with outward facets, so --excess cannot tell which side of it is material; "
          "expected a solid; repair it with gougecheck mesh --repair",
          surface.mesh().name);
    }
    columns.surfaces_.push_back(surface);
  }
  return columns;
}

std::optional<PartFacet> PartColumns::nearer(const FacetPiece& piece, double height_mm) const {
  if (!(height_mm > kInset_mm)) return std::nullopt;
  const Vec3 top = piece.middle() + height_mm * piece.normal;
  for (std::uint32_t m = 0; m < surfaces_.size(); ++m) {
    const auto closest = surfaces_[m].boundary().closest_point(top, height_mm - kInset_mm);
    if (closest) return PartFacet{m, closest->triangle};
  }
  return std::nullopt;
}

bool PartColumns::is_nearer(const PartFacet& facet, const FacetPiece& piece, double height_mm) const {
  const IndexedMesh& of = mesh(facet.mesh);
  const std::array<Vec3, 3> corners = {of.corner(facet.triangle, 0), of.corner(facet.triangle, 1),
                                       of.corner(facet.triangle, 2)};
  // The distance from a triangle is convex, so it is largest at a corner.
  return std::all_of(piece.corners.begin(), piece.corners.end(), [&](const Vec3& corner) {
    const Vec3 top = corner + height_mm * piece.normal;
    return std::sqrt(closest_on_triangle(top, corners).distance2_mm2) < height_mm - kInset_mm;
  });
}

bool PartColumns::is_lower(const FacetPiece& piece, double height_mm) const {
  // The distance from the part changes by at most the way between two points.
  const Vec3 top = piece.middle() + height_mm * piece.normal;
  const double within = height_mm - piece.radius_mm() - kInset_mm;
  return within > 0 && std::any_of(surfaces_.begin(), surfaces_.end(), [&](const Surface& surface) {
           return surface.boundary().closest_point(top, within).has_value();
         });
}

bool PartColumns::is_in_other(const FacetPiece& piece) const {
  const Vec3 middle = piece.middle();
  const double radius = piece.radius_mm() + Tolerance::kRounding_mm;
  for (std::size_t m = 0; m < surfaces_.size(); ++m) {
    const Surface& part = surfaces_[m].boundary();
    if (m != piece.mesh && !part.closest_point(middle, radius) && part.winds_around(middle)) return true;
  }
  return false;
}

bool PartColumns::is_free(const Prism& prism) const {
  // A facet that is nearer to a point of the prism than its foot comes within the height of its sides, above its base.
  std::array<HalfSpace, 5> around = Prism{prism.base, kInset_mm, 2 * prism.high_mm}.sides(0);
  for (std::size_t k = 0; k < 3; ++k) around[k].min_mm -= prism.high_mm;
  for (std::uint32_t m = 0; m < surfaces_.size(); ++m) {
    const Surface& part = surfaces_[m].boundary();
    if (is_entered(part.tree(), around)) {
      for (const std::uint32_t triangle : triangles_within(part.tree(), around))
        if (!is_apart({m, triangle}, prism)) return false;
    }
    if (m != prism.base.mesh && part.winds_around(prism.middle())) return false;
  }
  return true;
}

// Proves that a facet is below the base, or at least the height away from the top of the prism.
bool PartColumns::is_apart(const PartFacet& facet, const Prism& prism) const {
  const IndexedMesh& of = mesh(facet.mesh);
  const Vec3 normal = gouge::face_normal(of, facet.triangle);
  double highest = 0, lowest_above = prism.high_mm, highest_below = -prism.high_mm;
  for (std::size_t k = 0; k < 3; ++k) {
    highest = std::max(highest, prism.base.normal.dot(of.corner(facet.triangle, k) - prism.base.corners[0]));
    const Vec3 top = prism.base.corners[k] + prism.high_mm * prism.base.normal;
    const double above = normal.dot(top - of.corner(facet.triangle, 0));
    lowest_above = std::min(lowest_above, above);
    highest_below = std::max(highest_below, above);
  }
  return highest <= kInset_mm || lowest_above >= prism.high_mm - kInset_mm ||
         highest_below <= -prism.high_mm + kInset_mm;
}

}  // namespace gouge

#include "lib/stock/part_columns.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "lib/base/tolerance.h"
#include "lib/hierarchy/triangles_within.h"

namespace gouge {

namespace {

// Half of the width of a column about a line.
constexpr double kLine_mm = 1e-6;
// Sides of a prism are moved in by this much, so that facets that only touch it do not enter it.
constexpr double kInset_mm = 2 * Tolerance::kRounding_mm;

std::array<HalfSpace, 6> line_above(const Vec3& from, const Vec3& up, double height_mm) {
  const Vec3 x = up.unitOrthogonal(), y = up.cross(x);
  std::array<HalfSpace, 6> space;
  const auto between = [&](std::size_t k, const Vec3& direction, double low, double high) {
    const double at = direction.dot(from);
    space[k] = {direction, at + low};
    space[k + 1] = {-direction, -(at + high)};
  };
  between(0, x, -kLine_mm, kLine_mm);
  between(2, y, -kLine_mm, kLine_mm);
  between(4, up, -kLine_mm, height_mm + kLine_mm);
  return space;
}

}  // namespace

Result<PartColumns> PartColumns::of(std::span<const IndexedMesh> parts) {
  PartColumns columns;
  for (const IndexedMesh& mesh : parts) {
    const Surface surface(mesh);
    if (!surface.is_solid() || !surface.boundary().is_solid()) {
      return make_error(
          "excess-open-part",
          "the part is no closed mesh with outward facets, so --excess cannot tell which side of it is material; "
          "expected a solid; repair it with gougecheck mesh --repair",
          mesh.name);
    }
    columns.surfaces_.push_back(surface);
  }
  return columns;
}

std::optional<double> PartColumns::height_of(const Vec3& from, const Vec3& up, std::uint32_t mesh,
                                             std::uint32_t triangle) const {
  const IndexedMesh& of = this->mesh(mesh);
  const Vec3 normal = gouge::face_normal(of, triangle);
  const double along = normal.dot(up);
  if (std::abs(along) < Tolerance::kNoSide) return std::nullopt;
  const double height = normal.dot(of.corner(triangle, 0) - from) / along;
  const Vec3 at = from + height * up;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3& corner = of.corner(triangle, k);
    const Vec3 edge = of.corner(triangle, (k + 1) % 3) - corner;
    if (normal.cross(edge).dot(at - corner) < -Tolerance::kRounding_mm * edge.norm()) return std::nullopt;
  }
  return height;
}

std::optional<ColumnHit> PartColumns::first_hit(const FacetPiece& piece, double up_to_mm) const {
  std::optional<ColumnHit> first;
  const Vec3 from = piece.middle();
  for (std::uint32_t m = 0; m < surfaces_.size(); ++m) {
    const std::array<HalfSpace, 6> space = line_above(from, piece.normal, up_to_mm);
    for (const std::uint32_t triangle : triangles_within(surfaces_[m].boundary().tree(), space)) {
      if (m == piece.mesh && triangle == piece.triangle) continue;
      const std::optional<double> height = height_of(from, piece.normal, m, triangle);
      if (!height || *height < -Tolerance::kRounding_mm || *height > up_to_mm) continue;
      if (!first || *height < first->height_mm) first = ColumnHit{std::max(0.0, *height), m, triangle};
    }
  }
  return first;
}

bool PartColumns::is_blocked(const FacetPiece& piece, const ColumnHit& by, double up_to_mm) const {
  return std::all_of(piece.corners.begin(), piece.corners.end(), [&](const Vec3& corner) {
    const std::optional<double> height = height_of(corner, piece.normal, by.mesh, by.triangle);
    return height && *height >= -Tolerance::kRounding_mm && *height <= up_to_mm;
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
  const std::array<HalfSpace, 5> sides = prism.sides(kInset_mm);
  for (std::size_t m = 0; m < surfaces_.size(); ++m) {
    const Surface& part = surfaces_[m].boundary();
    if (is_entered(part.tree(), sides)) return false;
    if (m != prism.base.mesh && part.winds_around(prism.middle())) return false;
  }
  return true;
}

}  // namespace gouge

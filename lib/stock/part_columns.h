#pragma once

#include <optional>
#include <span>
#include <vector>

#include "lib/base/result.h"
#include "lib/stock/prism.h"
#include "lib/surface/surface.h"

namespace gouge {

/// Where a column meets the part again.
struct ColumnHit {
  double height_mm = 0;
  std::uint32_t mesh = 0, triangle = 0;
};

/// The surfaces of closed parts, asked for the columns above their facets. A column ends where it enters a part.
class PartColumns {
 public:
  /// The meshes must outlive it. Errors: a mesh is not closed, not oriented or has no known boundary.
  [[nodiscard]] static Result<PartColumns> of(std::span<const IndexedMesh> parts);

  /// Returns the boundary of a part, whose facets are asked.
  [[nodiscard]] const IndexedMesh& mesh(std::size_t part) const { return surfaces_[part].boundary().mesh(); }
  [[nodiscard]] std::size_t size() const { return surfaces_.size(); }

  /// Returns where the column above the middle of a piece first meets a part, up to a height.
  [[nodiscard]] std::optional<ColumnHit> first_hit(const FacetPiece& piece, double up_to_mm) const;
  /// Proves that every column of the piece meets the facet of a hit, up to a height.
  [[nodiscard]] bool is_blocked(const FacetPiece& piece, const ColumnHit& by, double up_to_mm) const;
  /// Proves that the piece lies in another part.
  [[nodiscard]] bool is_in_other(const FacetPiece& piece) const;
  /// Proves that no part is in the prism, apart from its sides. Requires that the column above the middle meets none.
  [[nodiscard]] bool is_free(const Prism& prism) const;

 private:
  PartColumns() = default;
  [[nodiscard]] std::optional<double> height_of(const Vec3& from, const Vec3& up, std::uint32_t mesh,
                                                std::uint32_t triangle) const;

  std::vector<Surface> surfaces_;
};

}  // namespace gouge

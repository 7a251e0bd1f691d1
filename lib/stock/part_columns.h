#pragma once

#include <optional>
#include <span>
#include <vector>

#include "lib/base/result.h"
#include "lib/stock/prism.h"
#include "lib/surface/surface.h"

namespace gouge {

/// A facet of a part.
struct PartFacet {
  std::uint32_t mesh = 0, triangle = 0;
};

/// The surfaces of closed parts, asked for the columns above their facets. A column ends where another point of a part is
/// nearer than its foot.
class PartColumns {
 public:
  /// The meshes of the surfaces must outlive it. Errors: a mesh is not closed, not oriented or has no known boundary.
  [[nodiscard]] static Result<PartColumns> of(std::span<const Surface> parts);

  /// Returns the boundary of a part, whose facets are asked.
  [[nodiscard]] const IndexedMesh& mesh(std::size_t part) const { return surfaces_[part].boundary().mesh(); }
  [[nodiscard]] std::size_t size() const { return surfaces_.size(); }

  /// Returns a facet that is nearer to the top of the column above the middle of a piece than its foot; none: the column
  /// is as high as that.
  [[nodiscard]] std::optional<PartFacet> nearer(const FacetPiece& piece, double height_mm) const;
  /// Proves that a facet is nearer to the top of every column of the piece than its foot.
  [[nodiscard]] bool is_nearer(const PartFacet& facet, const FacetPiece& piece, double height_mm) const;
  /// Proves that no column of the piece is as high as that, from the column above its middle.
  [[nodiscard]] bool is_lower(const FacetPiece& piece, double height_mm) const;
  /// Proves that the piece lies in another part.
  [[nodiscard]] bool is_in_other(const FacetPiece& piece) const;
  /// Proves that no facet is nearer to any point of the prism than its foot. Requires low_mm = 0, and that the middle of
  /// the piece is in no other part.
  [[nodiscard]] bool is_free(const Prism& prism) const;

 private:
  PartColumns() = default;
  [[nodiscard]] bool is_apart(const PartFacet& facet, const Prism& prism) const;

  std::vector<Surface> surfaces_;
};

}  // namespace gouge

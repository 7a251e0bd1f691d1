#pragma once

#include <optional>
#include <span>
#include <vector>

#include "lib/stock/column_proofs.h"

namespace gouge {

/// A piece of a facet above which material may be left higher than asked.
struct LeftPiece {
  FacetPiece piece;
  bool is_proved = false;  ///< every column of it is proved to be higher than asked
};

/// Limits of a search: the height that is asked for, and how closely the border of its area is found.
struct ExcessLimits {
  double height_mm = 0;
  double border_mm = 0;  ///< where a facet is proved to have more, pieces smaller than this are not divided
};

/// Returns the halves of a piece, divided at its longest edge.
[[nodiscard]] std::array<FacetPiece, 2> divided(const FacetPiece& piece);

/// Divides a facet until each piece is proved to have no more material than the asked height above it, or more, or is as
/// small as the resolution. Near a proof of more, or near a motion that is not known, `border_mm` is small enough. Adds all pieces but the first kind to `left`.
///
/// Ensures  Every column of the facet that is higher than asked + resolution, with cutters wider and the stock smaller by
///          the resolution, stands on a piece of `left`.
/// Cost     Some microseconds for each piece; pieces are about as large as the area that one move cuts.
/// Source   docs/method/stock.md.
void find_left(ColumnProofs& proofs, const ExcessQuestion& question, const FacetPiece& facet,
               const ExcessLimits& limits, std::vector<LeftPiece>& left);

/// The highest column of some pieces.
struct HighestColumn {
  double height_mm = 0;        ///< proved; 0: no column is proved to be higher than asked
  double height_upper_mm = 0;  ///< no column is higher, with cutters wider and the stock smaller by the resolution
  Vec3 point = Vec3::Zero();   ///< its foot on the facet
  FacetPiece at;               ///< the piece that it stands on
};

/// Finds the highest column of pieces that `find_left` left. Both bounds differ by three times the resolution, or by a tenth
/// of the height and the resolution, if the budget allows.
[[nodiscard]] HighestColumn find_highest(ColumnProofs& proofs, const ExcessQuestion& question,
                                         std::span<const LeftPiece> left, double height_mm);

}  // namespace gouge

#pragma once

#include <cstdint>
#include <optional>

#include "lib/stock/cut_history.h"
#include "lib/stock/part_columns.h"
#include "lib/stock/stock_solid.h"

namespace gouge {

/// The question about the material that a whole program leaves on a part.
struct ExcessQuestion {
  const CutHistory& history;
  const StockSolid& stock;
  const PartColumns& parts;
  double resolution_mm = 0;

  /// Returns a height that no column of material reaches.
  [[nodiscard]] double highest_mm() const { return (stock.high() - stock.low()).norm() + resolution_mm; }
};

/// Proofs about the columns of material above a piece of a facet. It keeps the moves that served last and are tried first,
/// so it belongs to one thread; no answer depends on them.
class ColumnProofs {
 public:
  explicit ColumnProofs(const ExcessQuestion& question) : q_(question), before_(question.history.path().moves.size()) {}

  /// Proves that every column of the piece ends at a height or below: there it is removed, beside the stock, or
  /// nearer to another facet. Cutters count as wider and the stock as smaller by the resolution; columns that end at another
  /// facet may be higher by it.
  [[nodiscard]] bool is_within(const FacetPiece& piece, double height_mm);
  /// Proves the same of the column above the middle of the piece alone.
  [[nodiscard]] bool is_middle_within(const FacetPiece& piece, double height_mm);
  /// Proves that every column of the piece is higher than that: all of it is stock that no tool touched, and
  /// nearest to its foot.
  [[nodiscard]] bool is_more(const FacetPiece& piece, double height_mm);
  /// Returns a height up to which the column above the middle of the piece is stock that no tool touched, and
  /// nearest to its foot; at most `up_to_mm`.
  [[nodiscard]] double height_left_mm(const FacetPiece& piece, double up_to_mm);
  /// Returns a move whose motion is not known and may have reached the columns of the piece.
  [[nodiscard]] CutMove unknown_near(const FacetPiece& piece, double height_mm) const;

  /// Returns the number of questions to the history.
  [[nodiscard]] std::uint64_t asked() const { return asked_; }

 private:
  [[nodiscard]] bool is_removed(const SweptPiece& lifted);
  [[nodiscard]] bool is_untouched(const Vec3& from, const Vec3& up, double low_mm, double high_mm, double radius_mm);
  [[nodiscard]] double climb(const FacetPiece& piece, double low_mm, double high_mm);

  const ExcessQuestion& q_;
  std::size_t before_;
  CutMove cut_hint_, touch_hint_;
  std::uint64_t asked_ = 0;
};

}  // namespace gouge

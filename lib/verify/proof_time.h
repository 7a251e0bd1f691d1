#pragma once

#include <cstddef>

#include "lib/verify/separation.h"

namespace gouge {

/// A part of the time of a proof: some pieces of motion, or a part of one piece.
struct ProofTime {
  ProofTime(const MotionPiece* begin, const MotionPiece* end, std::size_t index, double start = 0, double stop = 1)
      : first(begin), last(end), piece(index), from(start), until(stop), span(span_of(begin, end)) {}

  const MotionPiece *first, *last;
  std::size_t piece;   ///< index of the first piece
  double from, until;  ///< the part of a single piece, in [0, 1]; exact
  TimeSpan span;

  [[nodiscard]] bool is_one() const { return last - first == 1; }
  /// Returns the index of the last piece.
  [[nodiscard]] std::size_t last_piece() const { return piece + static_cast<std::size_t>(last - first) - 1; }
};

/// Calls `part(half)` for both halves of a time: of the number of pieces, or of a single piece. Stops if a call returns
/// false.
template <typename Part>
bool for_halves(const ProofTime& time, const Part& part) {
  if (time.is_one()) {
    const std::array<MotionPiece, 2> cut = time.first->halves();
    const double middle = 0.5 * (time.from + time.until);
    return part(ProofTime(&cut[0], &cut[0] + 1, time.piece, time.from, middle)) &&
           part(ProofTime(&cut[1], &cut[1] + 1, time.piece, middle, time.until));
  }
  const std::ptrdiff_t half = (time.last - time.first) / 2;
  return part(ProofTime(time.first, time.first + half, time.piece)) &&
         part(ProofTime(time.first + half, time.last, time.piece + static_cast<std::size_t>(half)));
}

}  // namespace gouge

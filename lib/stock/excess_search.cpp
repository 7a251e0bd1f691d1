#include "lib/stock/excess_search.h"

#include <algorithm>

#include "lib/geom/triangle.h"

namespace gouge {

namespace {

// After so many pieces of the size of the resolution that are neither proved to be within the height nor higher, the rest
// of a facet is left.
constexpr std::size_t kMaxOpenPieces = 32;
// Pieces up to this many times the height, or the resolution, are asked at lower heights too.
constexpr double kLowerSize = 8;
// The gap between the bounds of a height at which the search ends, as a share of it.
constexpr double kGap = 0.1;
// Number of pieces after which a facet, or the search for a highest column, is not divided further.
constexpr std::size_t kMaxPieces = 4'000'000, kMaxPiecesOfHighest = 20'000;

/// Proves that no column of a piece is higher than `height_mm`, from where the column above its middle ends.
bool ends_lower(ColumnProofs& proofs, const FacetPiece& piece, double reached_mm, double height_mm) {
  return proofs.is_within(piece, reached_mm) || proofs.is_within(piece, 0.5 * (reached_mm + height_mm));
}

class FacetSearch {
 public:
  FacetSearch(ColumnProofs& proofs, const ExcessQuestion& question, const ExcessLimits& limits,
              std::vector<LeftPiece>& left)
      : proofs_(proofs),
        q_(question),
        height_mm_(limits.height_mm),
        border_mm_(std::max(limits.border_mm, question.resolution_mm)),
        left_(left) {}

  void run(const FacetPiece& facet) {
    waiting_.push_back(facet);
    for (std::size_t examined = 0; !waiting_.empty(); ++examined) {
      const FacetPiece piece = waiting_.back();
      waiting_.pop_back();
      if (open_ >= kMaxOpenPieces || examined >= kMaxPieces) {
        left_.push_back({piece, false});
      } else {
        examine(piece);
      }
    }
  }

 private:
  void examine(const FacetPiece& piece) {
    if (proofs_.is_within(piece, height_mm_)) return;
    const double size = piece.radius_mm();
    if (size > q_.resolution_mm && proofs_.is_middle_within(piece, height_mm_)) return divide(piece);
    if (proofs_.is_more(piece, height_mm_)) {
      has_more_ = true;
      left_.push_back({piece, true});
      return;
    }
    if (has_more_ && size <= border_mm_) return left_.push_back({piece, false});
    const double reached = proofs_.height_left_mm(piece, height_mm_);
    if (reached >= height_mm_) {
      has_more_ = true;
    } else if (size <= kLowerSize * std::max(height_mm_, q_.resolution_mm) &&
               ends_lower(proofs_, piece, reached, height_mm_)) {
      return;
    }
    const bool is_coarse = has_more_ || static_cast<bool>(proofs_.unknown_near(piece, height_mm_));
    if (size > (is_coarse ? border_mm_ : q_.resolution_mm)) return divide(piece);
    if (reached < height_mm_) ++open_;
    left_.push_back({piece, false});
  }

  void divide(const FacetPiece& piece) {
    for (const FacetPiece& half : divided(piece)) waiting_.push_back(half);
  }

  ColumnProofs& proofs_;
  const ExcessQuestion& q_;
  double height_mm_, border_mm_;
  std::vector<LeftPiece>& left_;
  std::vector<FacetPiece> waiting_;
  bool has_more_ = false;
  std::size_t open_ = 0;
};

class HighestSearch {
 public:
  HighestSearch(ColumnProofs& proofs, const ExcessQuestion& question, double height_mm)
      : proofs_(proofs), q_(question), asked_mm_(height_mm) {
    best_.height_upper_mm = height_mm;
  }

  HighestColumn run(std::span<const LeftPiece> left) {
    // The last piece is examined first.
    for (const LeftPiece& one : left) waiting_.push_back(one.piece);
    std::reverse(waiting_.begin(), waiting_.end());
    while (!waiting_.empty()) {
      const FacetPiece piece = waiting_.back();
      waiting_.pop_back();
      examine(piece);
    }
    best_.height_upper_mm = std::max(best_.height_upper_mm, open_upper_mm_) + q_.resolution_mm;
    return best_;
  }

 private:
  void examine(const FacetPiece& piece) {
    ++examined_;
    if (proofs_.is_within(piece, best_.height_upper_mm)) return;
    const bool is_divisible =
        piece.radius_mm() > q_.resolution_mm && examined_ < kMaxPiecesOfHighest && open_ < kMaxOpenPieces;
    if (is_divisible && proofs_.is_middle_within(piece, best_.height_upper_mm)) return divide(piece);
    const double reached = proofs_.height_left_mm(piece, q_.highest_mm());
    if (reached >= asked_mm_ && reached > best_.height_mm) raise(piece, reached);
    if (ends_lower(proofs_, piece, reached, best_.height_upper_mm)) return;
    if (is_divisible) return divide(piece);
    ++open_;
    bound(piece);
  }

  void divide(const FacetPiece& piece) {
    for (const FacetPiece& half : divided(piece)) waiting_.push_back(half);
  }

  void raise(const FacetPiece& piece, double reached) {
    best_.height_mm = reached;
    best_.point = piece.middle();
    best_.at = piece;
    best_.height_upper_mm = std::max(best_.height_upper_mm, reached + std::max(kGap * reached, 2 * q_.resolution_mm));
  }

  /// Bounds the columns of a piece that is not divided further.
  void bound(const FacetPiece& piece) {
    double height = std::max(best_.height_upper_mm, open_upper_mm_);
    while (height < q_.highest_mm() && !proofs_.is_within(piece, height)) height *= 2;
    open_upper_mm_ = std::max(open_upper_mm_, std::min(height, q_.highest_mm()));
  }

  ColumnProofs& proofs_;
  const ExcessQuestion& q_;
  double asked_mm_, open_upper_mm_ = 0;
  HighestColumn best_;
  std::vector<FacetPiece> waiting_;
  std::size_t examined_ = 0, open_ = 0;
};

}  // namespace

std::array<FacetPiece, 2> divided(const FacetPiece& piece) {
  const auto parts = halves(piece.corners, longest_edge(piece.corners));
  std::array<FacetPiece, 2> both{piece, piece};
  for (std::size_t k = 0; k < 2; ++k) both[k].corners = parts[k];
  return both;
}

void find_left(ColumnProofs& proofs, const ExcessQuestion& question, const FacetPiece& facet,
               const ExcessLimits& limits, std::vector<LeftPiece>& left) {
  FacetSearch(proofs, question, limits, left).run(facet);
}

HighestColumn find_highest(ColumnProofs& proofs, const ExcessQuestion& question, std::span<const LeftPiece> left,
                           double height_mm) {
  return HighestSearch(proofs, question, height_mm).run(left);
}

}  // namespace gouge

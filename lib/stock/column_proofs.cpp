#include "lib/stock/column_proofs.h"

#include <algorithm>
#include <cmath>

#include "lib/base/tolerance.h"

namespace gouge {

namespace {

// The height of a column is known to this share of the resolution, or to this share of itself.
constexpr double kFinest = 0.125, kFinestShare = 0.01;

SweptPiece middle_lifted(const FacetPiece& piece, double height_mm) {
  SweptPiece lifted;
  lifted.at0[0].center = piece.middle() + height_mm * piece.normal;
  lifted.at1[0] = lifted.at0[0];
  lifted.count = 1;
  return lifted;
}

/// Returns the piece moved along its normal. Where it is smaller than the resolution, its middle stands for it.
SweptPiece lifted(const FacetPiece& piece, double height_mm, double resolution_mm) {
  SweptPiece lifted = middle_lifted(piece, height_mm);
  lifted.slack_mm = piece.radius_mm();
  if (lifted.slack_mm <= resolution_mm) return lifted;
  lifted = {};
  for (const Vec3& corner : piece.corners) lifted.at0[lifted.count++].center = corner + height_mm * piece.normal;
  lifted.at1 = lifted.at0;
  return lifted;
}

}  // namespace

bool ColumnProofs::is_removed(const SweptPiece& lifted) {
  ++asked_;
  return q_.stock.is_clear_of(lifted.start(), lifted.slack_mm - q_.resolution_mm) ||
         q_.history.is_removed(lifted, before_, cut_hint_);
}

bool ColumnProofs::is_within(const FacetPiece& piece, double height_mm) {
  if (is_removed(lifted(piece, height_mm, q_.resolution_mm))) return true;
  if (piece.radius_mm() <= q_.resolution_mm && q_.parts.is_lower(piece, height_mm + q_.resolution_mm)) return true;
  const std::optional<PartFacet> nearer = q_.parts.nearer(piece, height_mm);
  return (nearer && q_.parts.is_nearer(*nearer, piece, height_mm)) || q_.parts.is_in_other(piece);
}

bool ColumnProofs::is_middle_within(const FacetPiece& piece, double height_mm) {
  return is_removed(middle_lifted(piece, height_mm)) || q_.parts.nearer(piece, height_mm).has_value();
}

bool ColumnProofs::is_untouched(const Vec3& from, const Vec3& up, double low_mm, double high_mm, double radius_mm) {
  ++asked_;
  const double half = 0.5 * (high_mm - low_mm);
  const CutBall ball{from + (low_mm + half) * up, Vec2(radius_mm, half).norm() + Tolerance::kRounding_mm, up,
                     half + Tolerance::kRounding_mm};
  return q_.history.is_untouched(ball, before_, touch_hint_);
}

bool ColumnProofs::is_more(const FacetPiece& piece, double height_mm) {
  const Prism prism{piece, 0, height_mm};
  return q_.stock.contains(prism) && is_untouched(piece.middle(), piece.normal, 0, height_mm, piece.radius_mm()) &&
         q_.parts.is_free(prism);
}

double ColumnProofs::height_left_mm(const FacetPiece& piece, double up_to_mm) {
  if (q_.parts.is_in_other(piece)) return 0;
  double reached = 0;
  for (double step = q_.resolution_mm; reached < up_to_mm; step *= 2) {
    const double to = std::min(up_to_mm, reached + step), proved = climb(piece, reached, to);
    if (proved < to) return proved;
    reached = to;
  }
  return reached;
}

double ColumnProofs::climb(const FacetPiece& piece, double low_mm, double high_mm) {
  const Vec3 foot = piece.middle();
  if (q_.stock.contains(foot + low_mm * piece.normal, foot + high_mm * piece.normal) &&
      is_untouched(foot, piece.normal, low_mm, high_mm, 0) && !q_.parts.nearer(piece, high_mm))
    return high_mm;
  if (high_mm - low_mm <= std::max(kFinest * q_.resolution_mm, kFinestShare * low_mm)) return low_mm;
  const double middle = 0.5 * (low_mm + high_mm), reached = climb(piece, low_mm, middle);
  return reached < middle ? reached : climb(piece, middle, high_mm);
}

CutMove ColumnProofs::unknown_near(const FacetPiece& piece, double height_mm) const {
  return q_.history.unknown_near(piece.middle() + 0.5 * height_mm * piece.normal, before_,
                                 Vec2(piece.radius_mm(), 0.5 * height_mm).norm());
}

}  // namespace gouge

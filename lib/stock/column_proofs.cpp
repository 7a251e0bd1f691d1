#include "lib/stock/column_proofs.h"

#include <algorithm>
#include <cmath>

#include "lib/base/tolerance.h"

namespace gouge {

namespace {

// The height of a column is known to this share of the resolution, or to this share of itself.
constexpr double kFinest = 0.125, kFinestShare = 0.01;

}  // namespace

bool ColumnProofs::is_removed(const FacetPiece& piece, double height_mm) {
  ++asked_;
  SweptPiece lifted;
  const double size = piece.radius_mm();
  if (size <= q_.resolution_mm) {
    // The middle stands for the whole.
    lifted.slack_mm = size;
    lifted.at0[0].center = piece.middle() + height_mm * piece.normal;
    lifted.count = 1;
  } else {
    for (const Vec3& corner : piece.corners) lifted.at0[lifted.count++].center = corner + height_mm * piece.normal;
  }
  lifted.at1 = lifted.at0;
  return q_.stock.is_clear_of(lifted.start(), lifted.slack_mm - q_.resolution_mm) ||
         q_.history.is_removed(lifted, before_, cut_hint_);
}

bool ColumnProofs::is_within(const FacetPiece& piece, double height_mm) {
  if (is_removed(piece, height_mm)) return true;
  const std::optional<ColumnHit> hit = q_.parts.first_hit(piece, height_mm);
  return (hit && q_.parts.is_blocked(piece, *hit, height_mm)) || q_.parts.is_in_other(piece);
}

bool ColumnProofs::is_untouched(const Vec3& from, const Vec3& up, double low_mm, double high_mm, double radius_mm) {
  ++asked_;
  const double half = 0.5 * (high_mm - low_mm);
  const CutBall ball{from + (low_mm + half) * up, std::hypot(radius_mm, half) + Tolerance::kRounding_mm, up,
                     half + Tolerance::kRounding_mm};
  return q_.history.is_untouched(ball, before_, touch_hint_);
}

bool ColumnProofs::is_more(const FacetPiece& piece, double height_mm) {
  const Prism prism{piece, 0, height_mm};
  return q_.stock.contains(prism) && !q_.parts.first_hit(piece, height_mm) && q_.parts.is_free(prism) &&
         is_untouched(piece.middle(), piece.normal, 0, height_mm, piece.radius_mm());
}

double ColumnProofs::height_left_mm(const FacetPiece& piece, double up_to_mm) {
  const Vec3 from = piece.middle();
  const std::optional<ColumnHit> hit = q_.parts.first_hit(piece, up_to_mm);
  const double most = hit ? std::min(up_to_mm, hit->height_mm - Tolerance::kRounding_mm) : up_to_mm;
  if (!(most > 0) || q_.parts.is_in_other(piece)) return 0;
  double reached = 0;
  for (double step = q_.resolution_mm; reached < most; step *= 2) {
    const double to = std::min(most, reached + step), proved = climb({from, piece.normal, reached, to});
    if (proved < to) return proved;
    reached = to;
  }
  return reached;
}

double ColumnProofs::climb(const Stretch& s) {
  const double middle = 0.5 * (s.low_mm + s.high_mm);
  if (q_.stock.contains(s.from + s.low_mm * s.up, s.from + s.high_mm * s.up) &&
      is_untouched(s.from, s.up, s.low_mm, s.high_mm, 0))
    return s.high_mm;
  if (s.high_mm - s.low_mm <= std::max(kFinest * q_.resolution_mm, kFinestShare * s.low_mm)) return s.low_mm;
  const double reached = climb({s.from, s.up, s.low_mm, middle});
  return reached < middle ? reached : climb({s.from, s.up, middle, s.high_mm});
}

std::optional<std::size_t> ColumnProofs::unknown_near(const FacetPiece& piece, double height_mm) const {
  return q_.history.unknown_near(piece.middle() + 0.5 * height_mm * piece.normal, before_,
                                 std::hypot(piece.radius_mm(), 0.5 * height_mm));
}

}  // namespace gouge

#include "lib/stock/piece_placer.h"

namespace gouge {

namespace {

bool is_same(const MotionInterval& a, const MotionInterval& b) {
  return a.segment == b.segment && !(a.t0 < b.t0) && !(b.t0 < a.t0) && !(a.t1 < b.t1) && !(b.t1 < a.t1);
}

/// Adds the discs of a piece at both ends of an interval.
void place_piece(const ToolPiece& piece, const ToolPlace& a, const ToolPlace& b, SweptPiece& swept) {
  const PieceDiscs in_tool = discs_of(piece);
  swept.count = in_tool.count;
  for (std::size_t k = 0; k < in_tool.count; ++k) {
    const Disc& disc = in_tool.discs[k];
    swept.at0[k] = {a.of(disc.center), a.axes.col(2), disc.radius_mm};
    swept.at1[k] = {b.of(disc.center), b.axes.col(2), disc.radius_mm};
  }
}

}  // namespace

ToolPlace PiecePlacer::place_at(double t, std::uint32_t segment) const {
  return {of_head_ ? of_head_->at(t).rotation : motion_.axes_at(t), motion_.tip_at(t, segment)};
}

MotionRates PiecePlacer::rates_of(const MotionInterval& i) const {
  return of_head_ ? of_head_->rates(i.t0, i.t1, i.segment) : motion_.rates(i.t0, i.t1, i.segment);
}

void PiecePlacer::enter(const MotionInterval& i) {
  if (last_ && is_same(last_->interval, i)) return;
  last_ = Stretch{i, motion_.path_length_mm(i.t0, i.t1, i.segment),
                  of_head_ ? rates_of(i).turn_rad : motion_.turn_rad(i.t0, i.t1)};
  ends_.reset();
}

const PiecePlacer::Ends& PiecePlacer::ends() {
  if (!ends_) {
    const MotionInterval& i = last_->interval;
    const MotionRates rates = rates_of(i);
    ends_ =
        Ends{place_at(i.t0, i.segment), place_at(i.t1, i.segment), rates.tip_sag_mm, rates.axis_acceleration_rad() / 8};
  }
  return *ends_;
}

double PiecePlacer::way_mm(const ToolPiece& piece, const MotionInterval& interval) {
  enter(interval);
  return last_->length_mm + piece.reach_mm() * last_->turn_rad;
}

SweptPiece PiecePlacer::swept_by(const ToolPiece& piece, const MotionInterval& interval) {
  SweptPiece swept;
  const double size = piece.ball_mm() + way_mm(piece, interval);
  const bool is_flat = !piece.is_cylinder() && !(piece.half.minCoeff() > 0);
  if (size <= resolution_mm_ && !is_flat) {
    // The middle at one instant stands for the whole.
    swept.slack_mm = size + departure_.at_mm(piece.reach_mm());
    swept.at0[0] = {place_at(interval.middle(), interval.segment).of(piece.middle()), Vec3::UnitZ(), 0};
    swept.at1[0] = swept.at0[0];
    swept.count = 1;
    return swept;
  }
  swept.slack_mm = ends().tip_sag_mm + ends().axis_sag_rad * piece.reach_mm() + departure_.at_mm(piece.reach_mm());
  place_piece(piece, ends().start, ends().end, swept);
  return swept;
}

}  // namespace gouge

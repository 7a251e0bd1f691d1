#include "lib/verify/program_cuts.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lib/path/run_kind.h"
#include "lib/verify/bounds.h"
#include "lib/verify/claimed_pieces.h"
#include "lib/verify/witness_check.h"

namespace gouge {
namespace {

constexpr double kSlack_mm = 1e-6;  // for rounding
// A piece of time of a motion is not divided further once nothing in it moves by more than this.
constexpr double kFinest_mm = 1e-7;

// Below this length the bounds of a piece may not shrink any more, since each half has the rounding of its own bounds.
constexpr double kStagnation_mm = 1e-3;
constexpr double kShrunk = 0.75;  // share of the length before, to which half a piece shrinks

/// A question whether a cutter comes nearer to a point than a distance.
struct Approach {
  const ToolContour& cutter;
  const Vec3& point;
  double within_mm = 0;
  bool counts_open = false;  ///< the answer where rounding leaves it open
};

/// Returns whether the cutter may come that near during a piece of time. `before_mm` bounds the way in twice the piece.
bool may_come(const MotionPiece& piece, const Approach& asked, double before_mm) {
  const PoseBounds &from = piece.start(), &to = piece.end();
  const Pose pose = from.middle();
  const double distance = asked.cutter.nearest(in_tool(pose, asked.point)).signed_distance_mm;
  if (distance < asked.within_mm) return true;
  const double way = length(to.tip - from.tip).sup() + piece.sag_mm();
  const double turn = length(to.axis - from.axis).sup() + piece.bend();
  // The point moves in the cutter's frame by no more than this: an arc is at most twice as long as its chord here.
  const double longest = way + 2 * turn * ((asked.point - pose.tip).norm() + way);
  if (distance - longest > asked.within_mm) return false;
  if (longest < kFinest_mm) return true;
  if (longest < kStagnation_mm && longest > kShrunk * before_mm) return asked.counts_open;
  const auto halves = piece.halves();
  return may_come(halves[0], asked, longest) || may_come(halves[1], asked, longest);
}

}  // namespace

void ProgramCuts::Ball::add(const Vec3& point, double slack_mm) {
  if (radius_mm < 0) center = point;
  radius_mm = std::max({radius_mm, 0.0, (point - center).norm() + slack_mm});
}

ProgramCuts::ProgramCuts(const ClaimedProgram& program) : program_(program) {
  for (const ToolVariants* tool : program.bare)
    forms_.push_back(tool == nullptr ? nullptr : std::make_unique<const CutterForms>(*tool));
  const RoundsUpward upward;
  for (std::size_t i = 0; i < path().moves.size(); ++i) {
    if (i % kBlock == 0) blocks_.emplace_back();
    balls_.push_back(cuts(i) ? ball_of(i) : Ball{});
    if (std::isfinite(balls_[i].radius_mm)) longest_mm_ = std::max(longest_mm_, balls_[i].radius_mm);
    if (!(balls_[i].radius_mm < 0)) blocks_.back().add(balls_[i].center, balls_[i].radius_mm);
  }
}

const CutterForms* ProgramCuts::forms_of(std::size_t move) const {
  const std::size_t tool = path().moves[move].tool;
  return tool < forms_.size() ? forms_[tool].get() : nullptr;
}

bool ProgramCuts::is_known(std::size_t move) const {
  return path().moves[move].not_checked_reason.empty() && forms_of(move) != nullptr;
}

bool ProgramCuts::cuts(std::size_t move) const {
  const Move& m = path().moves[move];
  return is_known(move) && removes_stock(m) && program_.cuts[m.tool];
}

const ToolContour& ProgramCuts::body_of(std::size_t move) const {
  const CutterForms& forms = *forms_of(move);
  return cuts(move) ? forms.non_cutting : forms.whole;
}

std::optional<std::size_t> ProgramCuts::nearer(const Vec3& point, std::size_t before, double within_mm,
                                               bool counts_unknown) const {
  const RoundsUpward upward;
  for (std::size_t b = 0; b * kBlock < before; ++b) {
    if (is_beyond(blocks_[b], point, within_mm)) continue;
    for (std::size_t i = b * kBlock; i < std::min(before, (b + 1) * kBlock); ++i)
      if (!is_beyond(balls_[i], point, within_mm) && may_reach(i, point, within_mm, counts_unknown)) return i;
  }
  return std::nullopt;
}

bool ProgramCuts::is_beyond(const Ball& ball, const Vec3& point, double within_mm) const {
  return ball.radius_mm < 0 || (point - ball.center).norm() > ball.radius_mm + largest_mm_ + within_mm + kSlack_mm;
}

ProgramCuts::Ball ProgramCuts::ball_of(std::size_t move) {
  largest_mm_ = std::max(largest_mm_, forms_of(move)->cutting.size_mm());
  Ball ball;
  const auto pieces = claimed_pieces(scene(), move);
  if (!pieces) return {path().moves[move].end.tip, std::numeric_limits<double>::infinity()};
  for (const MotionPiece& piece : *pieces) {
    ball.add(piece.start().tip.middle(), piece.sag_mm() + kSlack_mm);
    ball.add(piece.end().tip.middle(), piece.sag_mm() + kSlack_mm);
  }
  return ball;
}

bool ProgramCuts::may_reach(std::size_t move, const Vec3& point, double within_mm, bool counts_unknown) const {
  const auto pieces = claimed_pieces(scene(), move);
  if (!pieces) return counts_unknown;
  const Approach asked{forms_of(move)->cutting, point, within_mm, counts_unknown};
  return std::ranges::any_of(*pieces, [&](const MotionPiece& piece) {
    return may_come(piece, asked, std::numeric_limits<double>::infinity());
  });
}

}  // namespace gouge

#include "postproc/cldata/interpreting/arc_senses.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "lib/base/number_text.h"
#include "lib/base/tolerance.h"
#include "postproc/cldata/interpreting/reasons.h"

namespace gouge {
namespace {

constexpr double kSmooth = 0.999;  // cosine of the angle between a line and an arc that continue each other smoothly
constexpr double kLeavesPlane_mm = 0.02;  // maximum difference of the radius at the start and at the end of an arc
constexpr double kTurningAxis = 1e-4;     // sine of an angle
constexpr std::size_t kClearVotes = 10;   // required ratio of votes for one sense to votes for the other
constexpr std::size_t kFewestVotes = 3;

ArcSense shorter_path(ArcStatement arc, const Vec3& start, const Vec3& end) {
  arc.sense = ArcSense::right_handed;
  const ArcFit right = fit_arc(arc, start, end);
  arc.sense = ArcSense::left_handed;
  const ArcFit left = fit_arc(arc, start, end);
  const double difference = std::abs(right.arc.sweep_rad) - std::abs(left.arc.sweep_rad);
  if (std::abs(difference) < 1) return ArcSense::unknown;
  return difference < 0 ? ArcSense::right_handed : ArcSense::left_handed;
}

}  // namespace

void ArcSenses::attach(ArcStatement arc, const Position& position, const Pose& start,
                       std::string_view other_uncertainty, Move& move) {
  const bool is_understood = arc.problem.empty();
  const bool runs_shorter_way = in_.dialect.arc_rule == ArcRule::shorter_path;
  if (runs_shorter_way && is_understood && !is_round(arc, position, start, move)) return;
  if (in_.dialect.arc_rule == ArcRule::by_vector_or_against && is_understood) mark_sense_uncertain(arc, start, move);
  const bool is_open = is_understood && arc.sense == ArcSense::unknown;
  if (is_understood && last_direction_) vote(arc, start.tip, *last_direction_);
  // Positions of one list on a circle run the shorter way. If the dialect always takes the shorter way, a single
  // position does too.
  if (is_open && (position.points > 1 || runs_shorter_way)) arc.sense = shorter_path(arc, start.tip, move.end.tip);
  // If the vector gives no sense, other arcs show nothing about this one.
  if (arc.sense == ArcSense::unknown && is_understood && !runs_shorter_way) {
    in_.make_room(open_);
    open_.push_back({in_.moves(), arc, other_uncertainty});
  }
  fit(arc, start.tip, move);
  const bool turns = start.axis.cross(move.end.axis).norm() > Tolerance::kSameDirection;
  if (turns && move.not_checked_reason == ArcProblems::kTiny) {
    move.cover = Cover::none;
    move.curve_kind = CurveKind::none;
  }
}

// Newer posts of Autodesk reverse the vector of a clockwise arc. Older ones keep it, so only the stated angle shows the
// sense. Half a turn, or a whole turn of a helix, does not show it. For a flat full circle both senses are equal.
void ArcSenses::mark_sense_uncertain(ArcStatement& arc, const Pose& start, const Move& move) {
  constexpr double kOpposite = -0.999;
  const Vec3& end = move.end.tip;
  if (fits_both_ways(arc, start.tip, end)) {
    const bool is_flat_circle =
        (end - start.tip).norm() <= 0 && start.axis.cross(move.end.axis).norm() <= Tolerance::kSameDirection;
    if (!is_flat_circle) arc.sense = ArcSense::unknown;
    return;
  }
  const bool is_right = fit_arc(arc, start.tip, end).problem.empty();
  if (is_right && arc.axis.dot(start.axis) < kOpposite) ++turned_vectors_;
  arc.sense = ArcSense::left_handed;
  if (!is_right && fit_arc(arc, start.tip, end).problem.empty()) ++reversed_arcs_;
  arc.sense = ArcSense::right_handed;
}

// Returns whether the motion to the position is on the arc. A list may begin with the present position of the tool. If
// an arc leaves its plane or turns the tool, it is uncertain: the post-processor of NCL itself runs it straight.
bool ArcSenses::is_round(const ArcStatement& arc, const Position& position, const Pose& start, Move& move) const {
  const Vec3 way = move.end.tip - start.tip;
  const bool turns = start.axis.cross(move.end.axis).norm() > kTurningAxis;
  if (position.points > 1 && position.point == 0 && way.norm() <= Tolerance::kFilePoint_mm) return false;
  if (!turns && std::abs(way.dot(arc.axis)) <= kLeavesPlane_mm) return true;
  move.not_checked_reason = Reasons::kNccsArc;
  return false;
}

void ArcSenses::fit(const ArcStatement& arc, const Vec3& start, Move& move) {
  const ArcFit fit = fit_arc(arc, start, move.end.tip);
  if (fit.problem == ArcProblems::kRadius) {
    radius_errors_.add(move.line);
    worst_radius_error_mm_ = std::max(worst_radius_error_mm_, fit.radius_error_mm);
  }
  move.not_checked_reason = fit.problem;
  if (fit.problem == ArcProblems::kTiny) return cover_by_circle(arc, start, move);
  // The other possible reading has one more turn; emit() adds it.
  if (fit.problem == ArcProblems::kTimes) move.cover = Cover::motion;
  if (!fit.problem.empty() && fit.problem != ArcProblems::kTimes) return;
  move.curve_kind = CurveKind::arc;
  move.curve = in_.path.arcs.size();
  in_.make_room(in_.path.arcs);
  in_.path.arcs.push_back(fit.arc);
}

// Covers the move by an arc from the start to the end plus one turn. Both senses lie on this arc. So does the full
// circle, if the tool keeps its axis and the arc its plane and radius.
void ArcSenses::cover_by_circle(ArcStatement arc, const Vec3& start, Move& move) {
  constexpr double kFlat_mm = 5e-4;
  const Vec3 way = move.end.tip - start;
  arc.sense = ArcSense::right_handed;
  const ArcFit fit = fit_arc(arc, start, move.end.tip);
  const bool is_read = fit.problem.empty() || fit.problem == ArcProblems::kTiny;
  if (!is_read || fit.radius_error_mm > kFlat_mm || std::abs(way.dot(arc.axis)) > kFlat_mm || arc.turns > 1) return;
  move.cover = Cover::motion;
  move.curve_kind = CurveKind::arc;
  move.curve = in_.path.arcs.size();
  in_.make_room(in_.path.arcs);
  in_.path.arcs.push_back(fit.arc);
  in_.path.arcs.back().sweep_rad += 2 * std::numbers::pi;
}

// Counts a line before or after an arc. It usually touches the arc, and so shows the sense of the arc.
void ArcSenses::vote(const ArcStatement& arc, const Vec3& tip, const Vec3& direction) {
  const double cosine = arc_tangent(arc, tip).dot(direction);
  if (std::abs(cosine) < kSmooth) return;
  ++(cosine > 0 ? right_votes_ : left_votes_);
  if (arc.sense == ArcSense::unknown) return;
  const bool is_as_read = (arc.sense == ArcSense::right_handed) == (cosine > 0);
  ++(is_as_read ? smooth_arcs_ : reversing_arcs_);
}

void ArcSenses::note_motion(const Move& move, const std::optional<Pose>& start) {
  last_direction_.reset();
  if (!move.has_start || move.kind == MoveKind::cycle || move.kind == MoveKind::arc) return;
  const Vec3 way = move.end.tip - start->tip;
  const double length = way.norm();
  if (!(length > Tolerance::kFilePoint_mm)) return;
  last_direction_ = way / length;
  if (!open_.empty() && open_.back().move + 1 == in_.moves()) vote(open_.back().arc, start->tip, *last_direction_);
}

void ArcSenses::uncertainty(std::size_t begin, std::size_t end, std::string_view reason) {
  for (auto open = open_.rbegin(); open != open_.rend() && open->move >= begin; ++open) {
    if (open->move < end && open->not_checked_reason.empty()) open->not_checked_reason = reason;
  }
}

// Decides the sense of all arcs of a file whose dialect states none: the one in which they continue lines smoothly.
void ArcSenses::close() {
  if (open_.empty()) return;
  if (in_.dialect.arc_rule == ArcRule::by_vector_or_against) {
    // A clockwise arc with a reversed vector, and none with an unchanged vector, shows which posts wrote the file.
    turned_vectors_ > 0 && reversed_arcs_ == 0 ? close_as(ArcSense::right_handed) : cover_both_senses();
    return;
  }
  const bool is_right = right_votes_ >= kFewestVotes && right_votes_ >= kClearVotes * left_votes_;
  const bool is_left = left_votes_ >= kFewestVotes && left_votes_ >= kClearVotes * right_votes_;
  if (!is_right && !is_left) return cover_both_senses();
  close_as(is_right ? ArcSense::right_handed : ArcSense::left_handed);
  const std::size_t votes = is_right ? right_votes_ : left_votes_;
  in_.path.notes.push_back(make_note(
      "path-arc-sense",
      "the dialect states no sense for arcs; taken as " +
          std::string(is_right ? "right-handed (counter-clockwise)" : "left-handed (clockwise)") +
          " about their vector, as at " + std::to_string(votes) + " of " + std::to_string(right_votes_ + left_votes_) +
          " points where a line touches an arc it goes on smoothly",
      in_.path.file));
}

void ArcSenses::cover_both_senses() {
  for (const OpenArc& open : open_) {
    Move& move = in_.path.moves[open.move];
    const bool is_covered = move.not_checked_reason == ArcProblems::kSense && open.not_checked_reason.empty() &&
                            in_.path.start_of(open.move).axis.cross(move.end.axis).norm() <= Tolerance::kSameDirection;
    if (is_covered) cover_by_circle(open.arc, in_.path.start_of(open.move).tip, move);
  }
}

void ArcSenses::close_as(ArcSense sense) {
  for (OpenArc& open : open_) {
    open.arc.sense = sense;
    Move& move = in_.path.moves[open.move];
    if (move.not_checked_reason != ArcProblems::kSense) continue;
    fit(open.arc, in_.path.start_of(open.move).tip, move);
    if (move.not_checked_reason.empty()) move.not_checked_reason = open.not_checked_reason;
  }
}

void ArcSenses::write_notes() const {
  in_.report(Severity::warning, "path-arc-radius", radius_errors_, "arc",
             " whose start, end and radius do not lie on one circle (off by up to " +
                 fixed_text(worst_radius_error_mm_, 3) + " mm) not checked");
  constexpr std::size_t kFewest = 3;
  if (reversing_arcs_ >= kFewest && reversing_arcs_ > 2 * smooth_arcs_) {
    in_.path.notes.push_back(make_warning(
        "path-arc-sense",
        count_text(reversing_arcs_, "arc") + " run back against the line before them, " + std::to_string(smooth_arcs_) +
            " go on smoothly: another dialect may have written this file (--dialect)",
        in_.path.file));
  }
}

}  // namespace gouge

#include "lib/correct/laws.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "lib/correct/plan_holes.h"
#include "lib/motion/motion.h"
#include "lib/path/run_kind.h"

namespace gouge {
namespace {

constexpr double kSameTurn_rad = 0.05;  // far more than the rounding of an arc's digits, far less than a turn in the
                                        // other direction
constexpr double kDigits_mm = 0.006;
const std::optional<PathArc> kStraight;

bool is_same_pose(const Pose& a, const Pose& b) { return a.tip == b.tip && a.axis == b.axis; }

// Returns whether the poses agree up to the digits of a file in which a position is written again.
bool is_near(const Pose& a, const Pose& b) {
  constexpr double kDigitsOfAxis = 1e-5;
  return (a.tip - b.tip).norm() <= kDigits_mm && (a.axis - b.axis).norm() <= kDigitsOfAxis;
}

bool is_same_curve(const Toolpath& a, const Move& ma, const Toolpath& b, const Move& mb) {
  if (ma.curve_kind != mb.curve_kind) return false;
  if (ma.curve_kind == CurveKind::arc) {
    const PathArc &x = a.arcs[ma.curve], &y = b.arcs[mb.curve];
    return x.center == y.center && x.axis == y.axis && std::equal_to<>()(x.sweep_rad, y.sweep_rad);
  }
  if (ma.curve_kind == CurveKind::none) return true;
  const std::vector<SplinePiece>&x = a.splines[ma.curve].pieces, &y = b.splines[mb.curve].pieces;
  return x.size() == y.size() &&
         std::equal(x.begin(), x.end(), y.begin(), [](const SplinePiece& p, const SplinePiece& q) {
           return p.control == q.control && std::equal_to<>()(p.u0, q.u0) && std::equal_to<>()(p.u1, q.u1);
         });
}

bool is_same_motion(const Toolpath& a, std::size_t i, const Toolpath& b, std::size_t k) {
  const Move &ma = a.moves[i], &mb = b.moves[k];
  if (ma.kind != mb.kind || ma.has_start != mb.has_start || !is_same_pose(ma.end, mb.end)) return false;
  return (!ma.has_start || is_same_pose(a.start_of(i), b.start_of(k))) && is_same_curve(a, ma, b, mb);
}

/// Returns whether the motions that replaced the move turn as the change states, and not in the other direction.
bool turns_as_asked(const PathChange& change, const Toolpath& after, const MovesAfter& span) {
  for (std::size_t k = span.first; k < span.last; ++k) {
    const std::size_t piece = k - span.first;
    const bool is_own = k + 1 == span.last;
    if (is_own && !change.new_arc && !change.is_straightened) continue;
    const std::optional<PathArc>& asked = is_own                                ? change.new_arc
                                          : piece < change.inserted_arcs.size() ? change.inserted_arcs[piece]
                                                                                : kStraight;
    const Move& move = after.moves[k];
    if (asked.has_value() != (move.curve_kind == CurveKind::arc)) return false;
    if (!asked) continue;
    const PathArc& arc = after.arcs[move.curve];
    if ((arc.sweep_rad * arc.axis - asked->sweep_rad * asked->axis).norm() > kSameTurn_rad) return false;
  }
  return true;
}

/// Returns whether the state of an unchanged motion is acceptable. The same motion is as deep as before. Only the path
/// that leads to it may show more or less of which side is inside.
bool has_kept_state(const MoveVerdict& before, const MoveVerdict& after) {
  return before.state == after.state || after.state == MoveState::clean ||
         (before.state == MoveState::not_certified && after.state != MoveState::buried);
}

class LawsCheck {
 public:
  LawsCheck(const CheckedPath& before, const std::vector<PathChange>& changes, const CheckedPath& after,
            const CheckOptions& options)
      : before_(before), after_(after), options_(options), change_of_(before.path->moves.size(), nullptr) {
    for (const PathChange& change : changes) {
      const std::size_t last = change.hole_shift_mm ? end_of_hole(*before.path, change.move) : change.move + 1;
      for (std::size_t i = change.move; i < last; ++i) change_of_[i] = &change;
    }
  }

  [[nodiscard]] bool is_lawful(std::size_t i, const MovesAfter& span) const {
    const Toolpath &a = *before_.path, &b = *after_.path;
    const Move &old = a.moves[i], &own = b.moves[span.last - 1];
    const PathChange* change = change_of_[i];
    if (own.tool != old.tool || own.not_checked_reason != old.not_checked_reason) return false;
    const bool may_end_elsewhere = change != nullptr && (change->new_end || change->hole_shift_mm);
    if (!may_end_elsewhere && !is_same_pose(own.end, old.end)) return false;
    const bool is_rapid_asked = change != nullptr && change->is_end_at_rapid();
    if (is_rapid_asked ? own.kind != MoveKind::rapid
                       : (own.kind != old.kind || runs_rapid(own) != runs_rapid(old)) &&
                             !(change != nullptr && change->is_straightened))
      return false;
    if (change != nullptr && change->has_arc() && !turns_as_asked(*change, b, span)) return false;
    const MoveVerdict& was = before_.result->verdicts[i];
    if (is_same_motion(a, i, b, span.last - 1) && span.last - span.first == 1)
      return has_kept_state(was, after_.result->verdicts[span.first]);
    if (change == nullptr && !is_same_curve(a, old, b, own)) return false;
    for (std::size_t k = span.first; k < span.last; ++k) {
      const MoveVerdict& is = after_.result->verdicts[k];
      if (!is_no_worse_than(was, is, options_.resolution_mm)) return false;
      if (is.state != MoveState::gouge || !old.has_start || old.kind == MoveKind::cycle) continue;
      const bool is_curve = old.curve_kind != CurveKind::none;
      if (is_curve ? !is_on_programmed_arc(i, k) : !is_programmed_or_shift(i, k, span)) return false;
    }
    return true;
  }

 private:
  /// Returns whether piece `k` of straight move `i` is the programmed motion or a part of it. It may also lead from the
  /// old end to the new one. A feed may lead from its new start to the old one, and back to its old end if a rapid
  /// begins there; a rapid would plunge. Elsewhere a motion that still gouges could cut places that it did not cut
  /// before, even if it is less deep than its deepest point.
  [[nodiscard]] bool is_programmed_or_shift(std::size_t i, std::size_t k, const MovesAfter& span) const {
    const Toolpath &a = *before_.path, &b = *after_.path;
    if (!b.moves[k].has_start) return false;
    const bool begins_at_start = is_near(b.start_of(k), a.start_of(i)),
               ends_at_end = is_near(b.moves[k].end, a.moves[i].end);
    if (begins_at_start && ends_at_end) return true;
    if (a.moves[i].kind == MoveKind::feed && is_on_programmed(i, b.start_of(k)) && is_on_programmed(i, b.moves[k].end))
      return true;
    const bool is_first = k == span.first, is_last = k + 1 == span.last;
    if (is_last && !is_first && is_near(b.start_of(k), a.moves[i].end)) return true;
    if (runs_rapid(a.moves[i])) return false;
    const bool precedes_rapid =
        i + 1 < a.moves.size() && a.moves[i + 1].has_start && runs_rapid(a.moves[i + 1]) && is_last && !is_first;
    return (is_first && !is_last && is_near(b.moves[k].end, a.start_of(i))) || (precedes_rapid && ends_at_end);
  }

  /// Returns whether piece `k` runs on the circle of arc `i`, with the same tool axis. A curve that became straight moves,
  /// or an arc with another radius, must not gouge: it could cut places that the programmed curve did not cut, and many
  /// moves would stay in place of one without any gain.
  [[nodiscard]] bool is_on_programmed_arc(std::size_t i, std::size_t k) const {
    const Toolpath &a = *before_.path, &b = *after_.path;
    const Move &old = a.moves[i], &own = b.moves[k];
    if (old.curve_kind != CurveKind::arc || own.curve_kind != CurveKind::arc || !own.has_start) return false;
    const PathArc &was = a.arcs[old.curve], &is = b.arcs[own.curve];
    const auto across = [&](const Vec3& from, const Vec3& to) -> Vec3 {
      const Vec3 way = to - from;
      return way - way.dot(was.axis) * was.axis;  // a helix has the centers of its pieces at several heights
    };
    const double radius_mm = across(was.center, a.start_of(i).tip).norm(),
                 now_mm = across(is.center, b.start_of(k).tip).norm();
    const bool is_same_circle = is_near({across(was.center, is.center), is.axis}, {Vec3::Zero(), was.axis}) &&
                                std::abs(now_mm - radius_mm) <= kDigits_mm;
    return is_same_circle && is_near(own.end, {own.end.tip, old.end.axis});
  }

  /// Returns whether the tool passes the pose on straight move `i`. A straight motion between two such poses is a part
  /// of the move.
  [[nodiscard]] bool is_on_programmed(std::size_t i, const Pose& pose) const {
    const Motion motion = options_.law.straight(before_.path->start_of(i), before_.path->moves[i].end);
    const Vec3 along = motion.end().tip - motion.start().tip;
    if (!options_.law.is_divisible(MoveKind::feed) || !motion.is_defined() || !(along.norm() > 0)) return false;
    const double t = std::clamp((pose.tip - motion.start().tip).dot(along) / along.squaredNorm(), 0.0, 1.0);
    return is_near(motion.at(t), pose);
  }

  const CheckedPath& before_;
  const CheckedPath& after_;
  const CheckOptions& options_;
  std::vector<const PathChange*> change_of_;
};

/// Returns whether a hole has as many steps as before. A hole that was moved may need a step more or less.
bool has_same_steps(const Toolpath& before, std::size_t i, const Toolpath& after, std::size_t k) {
  return k < after.moves.size() && end_of_hole(before, i) - i == end_of_hole(after, k) - k;
}

}  // namespace

bool is_no_worse_than(const MoveVerdict& before, const MoveVerdict& after, double resolution_mm) {
  if (after.state == MoveState::clean) return true;
  if (after.state == MoveState::near_miss) return before.state != MoveState::clean;
  // A rapid that was left out on request is still left out.
  if (after.state == MoveState::not_checked)
    return before.state == after.state && before.reason.is(Reason::Kind::rapid_skipped) &&
           after.reason.is(Reason::Kind::rapid_skipped);
  if (after.state != MoveState::gouge || before.state != MoveState::gouge) return false;
  return after.depth_mm <= before.depth_upper_mm && after.depth_upper_mm <= before.depth_mm + 2 * resolution_mm;
}

std::vector<MovesAfter> moves_after(std::size_t moves, const std::vector<PathChange>& changes) {
  std::vector<std::size_t> inserted(moves, 0);
  for (const PathChange& change : changes) inserted[change.move] = change.inserted_before.size();
  std::vector<MovesAfter> after(moves);
  std::size_t next = 0;
  for (std::size_t i = 0; i < moves; ++i) {
    after[i] = {next, next + inserted[i] + 1};
    next = after[i].last;
  }
  return after;
}

std::vector<std::size_t> find_worse(const CheckedPath& before, const std::vector<PathChange>& changes,
                                    const CheckedPath& after, const CheckOptions& options) {
  const std::size_t count = before.path->moves.size();
  const std::vector<MovesAfter> spans = moves_after(count, changes);
  std::vector<std::size_t> worse;
  for (const PathChange& change : changes) {
    if (change.hole_shift_mm && !has_same_steps(*before.path, change.move, *after.path, spans[change.move].first))
      return {change.move};  // later moves do not have the expected indices then
  }
  const bool is_as_long = count == 0 || spans.back().last == after.path->moves.size();
  const LawsCheck check(before, changes, after, options);
  for (std::size_t i = 0; i < count; ++i) {
    if (!is_as_long || !check.is_lawful(i, spans[i])) worse.push_back(i);
  }
  return worse;
}

}  // namespace gouge

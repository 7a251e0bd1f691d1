#include "lib/correct/plan_trims.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "lib/base/number_text.h"
#include "lib/base/tolerance.h"
#include "lib/base/units.h"
#include "lib/contact/contacts.h"
#include "lib/correct/clean_intervals.h"
#include "lib/correct/lifts.h"
#include "lib/motion/motion_law.h"
#include "lib/path/path_info.h"

namespace gouge {
namespace {

// A clean stretch between two left-out stretches is cut only if it is longer than this: a shorter cut is not worth a
// plunge.
constexpr double kMinCut_mm = 2;
// Distances before and after the stretch at which another place to retract is tried.
constexpr std::array kAway_mm = {0.0, 0.05, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0};

Pose lifted(const Pose& pose, double lift_mm) { return {pose.tip + lift_mm * pose.axis, pose.axis}; }

/// A stretch of the path on which the tool is certified to be free.
struct FreeStretch {
  PathPlace begin, end;
};

/// Moves [first, last) of one tool, each straight and beginning at the end of the one before.
class TrimChain {
 public:
  TrimChain(const TrimJob& job, std::size_t first, std::size_t last)
      : job_(job), tool_(*job.tools[job.path.moves[first].tool]), first_(first), last_(last) {}

  void plan(TrimPlan& plan) {
    find_free();
    // Gap k is before free stretch k.
    for (std::size_t k = 0; k <= free_.size();) k = close_gap(k, plan);
  }

 private:
  static constexpr std::size_t kMaxGaps = 8;  // maximum number of gaps that are left out together if one alone cannot
                                              // be
  static constexpr const char* kNothingBefore = "not left out: the path has no free place before it to retract from";
  static constexpr const char* kNothingAfter = "not left out: the path has no free place after it to come down to";

  /// Leaves out the wanted part of a gap, together with the gaps after it if necessary. Returns the next gap to
  /// examine.
  std::size_t close_gap(std::size_t k, TrimPlan& plan) {
    const bool is_first = k == 0, is_last = k == free_.size();
    const PathPlace from = is_first ? PathPlace{first_, 0} : free_[k - 1].end;
    const PathPlace to = is_last ? PathPlace{last_ - 1, 1} : free_[k].begin;
    const auto [first_wanted, last_wanted] = wanted_between(from, to);
    if (first_wanted == kNone) return k + 1;
    if (is_first || is_last) {
      plan.failed.push_back({first_wanted, last_wanted, is_first ? kNothingBefore : kNothingAfter});
      return k + 1;
    }
    for (std::size_t right = k; right < std::min(k + kMaxGaps, free_.size()); ++right) {
      auto trim = leave_out(free_[k - 1], free_[right]);
      if (!trim) continue;
      free_[right].begin = trim->end;
      plan.trims.push_back(std::move(*trim));
      return right + 1;
    }
    plan.failed.push_back({first_wanted, last_wanted, no_path_over()});
    return k + 1;
  }

  [[nodiscard]] std::string no_path_over() const {
    const LengthUnit unit = job_.path.unit;
    return "not left out: no way over it was found with lifts up to --max-shift " +
           display_text(job_.max_lift_mm / mm_per(unit), unit == LengthUnit::mm ? 3 : 4) + " " + unit_name(unit) +
           ", with --rapid-clearance where rapids are on the way";
  }

  [[nodiscard]] const Move& move(std::size_t i) const { return job_.path.moves[i]; }
  [[nodiscard]] bool has_way(std::size_t i) const { return move(i).has_start; }
  [[nodiscard]] Motion motion(std::size_t i) const { return job_.checker.options().law.of(job_.path, i); }
  [[nodiscard]] Pose pose(const PathPlace& place) const {
    return has_way(place.move) ? motion(place.move).at(place.t) : move(place.move).end;
  }
  [[nodiscard]] double length_mm(std::size_t i) const { return has_way(i) ? move_length_mm(job_.path, i) : 0; }

  [[nodiscard]] CheckOptions options_for(bool keeps_near, double clearance_mm) const {
    CheckOptions options = job_.checker.options();
    options.tolerance_mm *= kMotionAimShare;
    options.near_miss_mm = std::max(keeps_near ? options.near_miss_mm : 0, clearance_mm);
    return options;
  }
  [[nodiscard]] bool was_clean(std::size_t i) const { return job_.result.verdicts[i].state == MoveState::clean; }

  /// Finds the free stretches of the whole chain, without those that are too short to be cut.
  void find_free() {
    for (std::size_t i = first_; i < last_; ++i) {
      const MoveState state = job_.result.verdicts[i].state;
      if (state == MoveState::clean || state == MoveState::near_miss) {
        add_free({{i, 0}, {i, 1}});
      } else if (has_way(i) && motion(i).is_defined()) {
        const Motion programmed = motion(i);
        const CheckOptions options = options_for(false, 0);
        const auto is_clean = [&](double t0, double t1) {
          const Motion piece = options.law.between(programmed.at(t0), programmed.at(t1), move(i).kind);
          return job_.checker.is_clean(piece, move(i).kind, tool_, options);
        };
        for (const TimeInterval& free : find_clean_intervals(programmed, is_clean))
          add_free({{i, free.first}, {i, free.last}});
      }
    }
    std::erase_if(free_, [&](const FreeStretch& stretch) {
      const bool is_at_end = is_same(stretch.begin, {first_, 0}) || is_same(stretch.end, {last_ - 1, 1});
      return !is_at_end && arc_length_mm(stretch.begin, stretch.end) < kMinCut_mm;
    });
  }

  void add_free(const FreeStretch& stretch) {
    if (!free_.empty() && is_same(free_.back().end, stretch.begin)) {
      free_.back().end = stretch.end;
    } else {
      free_.push_back(stretch);
    }
  }

  [[nodiscard]] static bool is_same(const PathPlace& a, const PathPlace& b) {
    if (a.move == b.move) return !(a.t < b.t) && !(b.t < a.t);
    return a.move < b.move ? a.move + 1 == b.move && !(a.t < 1) && !(b.t > 0)
                           : b.move + 1 == a.move && !(b.t < 1) && !(a.t > 0);
  }

  /// Returns the length of the programmed path between two places.
  [[nodiscard]] double arc_length_mm(const PathPlace& from, const PathPlace& to) const {
    double way = 0;
    for (std::size_t i = from.move; i <= to.move; ++i) {
      const double t0 = i == from.move ? from.t : 0, t1 = i == to.move ? to.t : 1;
      way += (t1 - t0) * length_mm(i);
    }
    return way;
  }

  /// Returns the first and last wanted move of which a part lies between two places; kNone if there is none.
  [[nodiscard]] std::pair<std::size_t, std::size_t> wanted_between(const PathPlace& from, const PathPlace& to) const {
    std::pair<std::size_t, std::size_t> found{kNone, kNone};
    for (std::size_t i = from.move; i <= to.move && i < last_; ++i) {
      const double t0 = i == from.move ? from.t : 0, t1 = i == to.move ? to.t : 1;
      if (!job_.is_wanted[i] || (!(t1 > t0) && has_way(i))) continue;
      if (found.first == kNone) found.first = i;
      found.second = i;
    }
    return found;
  }

  /// Returns the places of a free stretch at the distances kAway_mm before its end.
  [[nodiscard]] std::vector<PathPlace> places_back(const FreeStretch& stretch) const {
    std::vector<PathPlace> places;
    for (const double away : kAway_mm) {
      PathPlace at = stretch.end;
      double left = away;
      while (left > at.t * length_mm(at.move) && at.move > stretch.begin.move) {
        left -= at.t * length_mm(at.move);
        at = {at.move - 1, 1};
      }
      const double length = length_mm(at.move);
      at.t = length > 0 ? at.t - left / length : 0;
      if (at.move == stretch.begin.move && at.t < stretch.begin.t) break;
      // A place at the end of a move becomes the beginning of the next one, which is not visited completely.
      if (!(at.t < 1)) at = {at.move + 1, 0};
      if (at.move < last_ && has_way(at.move)) places.push_back(at);
    }
    return places;
  }
  [[nodiscard]] std::vector<PathPlace> places_on(const FreeStretch& stretch) const {
    std::vector<PathPlace> places;
    for (const double away : kAway_mm) {
      PathPlace at = stretch.begin;
      double left = away;
      while (left > (1 - at.t) * length_mm(at.move) && at.move < stretch.end.move) {
        left -= (1 - at.t) * length_mm(at.move);
        at = {at.move + 1, 0};
      }
      const double length = length_mm(at.move);
      at.t = length > 0 ? at.t + left / length : 1;
      if (at.move == stretch.end.move && at.t > stretch.end.t) break;
      if (!(at.t > 0)) {
        if (at.move == first_) continue;
        at = {at.move - 1, 1};
      }
      places.push_back(at);
    }
    return places;
  }

  /// Finds the first of `places`, from `next` on, at which the tool may retract by the lift. An obstacle to a lift is
  /// also an obstacle to every longer lift. A rapid is left, and joined again, at a place where it keeps the clearance,
  /// without a way up.
  [[nodiscard]] bool find_retract(const std::vector<PathPlace>& places, std::size_t& next, double lift_mm) const {
    for (; next < places.size(); ++next) {
      const Pose low = pose(places[next]);
      const std::size_t i = places[next].move;
      const double clearance = is_on_rapid(places[next]) ? job_.clearance_mm : 0;
      if (is_clean(low, above(places[next], lift_mm), move(i).kind, options_for(was_clean(i), clearance))) return true;
    }
    return false;
  }

  [[nodiscard]] bool is_on_rapid(const PathPlace& place) const { return move(place.move).kind == MoveKind::rapid; }
  /// Returns the pose at which the crossing begins or ends, for a place at which the path is left or joined.
  [[nodiscard]] Pose above(const PathPlace& place, double lift_mm) const {
    return is_on_rapid(place) ? pose(place) : lifted(pose(place), lift_mm);
  }

  [[nodiscard]] bool has_rapid(const PathPlace& from, const PathPlace& to) const {
    for (std::size_t i = from.move; i <= to.move; ++i) {
      if (move(i).kind == MoveKind::rapid) return true;
    }
    return false;
  }

  /// Returns whether the lift is above the stock. The height of the stock above the uncut part is not known. But where
  /// the path last changed from rapid to feed, the program states that the tool is above the stock. So feeds become
  /// rapids no lower than that place.
  [[nodiscard]] bool is_above_stock(const PathPlace& from, double lift_mm) const {
    if (is_on_rapid(from)) return true;
    const Pose begin = pose(from);
    for (std::size_t i = from.move; i-- > 0;) {
      if (move(i).tool != move(from.move).tool) return false;
      if (move(i).kind != MoveKind::rapid) continue;
      const Pose& entry = move(i).end;
      return (entry.axis - begin.axis).norm() <= Tolerance::kNoSide &&
             lift_mm >= (entry.tip - begin.tip).dot(begin.axis);
    }
    return false;
  }

  /// Leaves out the stretch between two free stretches. Without the clearance, neither a new nor a programmed rapid may
  /// be on the way.
  [[nodiscard]] std::optional<Trim> leave_out(const FreeStretch& before, const FreeStretch& after) const {
    const std::vector<PathPlace> downs = places_on(after), ups = places_back(before);
    std::vector<double> clearances{job_.clearance_mm};
    if (job_.clearance_mm > 0) clearances.push_back(0);
    for (const double clearance : clearances) {
      std::size_t up = 0, down = 0;
      for (const double lift : lifts_up_to(job_.max_lift_mm)) {
        if (!find_retract(ups, up, lift) || !find_retract(downs, down, lift)) break;
        if (has_rapid(ups[up], downs[down]) && (clearance < job_.clearance_mm || lift < clearance)) continue;
        if (auto trim = cross(ups[up], downs[down], lift, clearance)) return trim;
      }
    }
    return std::nullopt;
  }

  /// Returns the way up, across and down: across on a straight line, or above the programmed path.
  [[nodiscard]] std::optional<Trim> cross(const PathPlace& from, const PathPlace& to, double lift,
                                          double clearance) const {
    const Pose up = above(from, lift), down = above(to, lift);
    const bool is_rapid = job_.can_write_rapids && clearance > 0 && lift >= clearance && is_above_stock(from, lift) &&
                          job_.checker.options().law.rapid() != RapidMode::skip;
    std::vector<Pose> programmed, straight, above;
    for (std::size_t i = from.move; i < to.move; ++i) programmed.push_back(move(i).end);
    const double whole = arc_length_mm(from, to);
    const Motion line = job_.checker.options().law.straight(up, down);
    for (std::size_t k = 0; k < programmed.size(); ++k) {
      const double even = static_cast<double>(k + 1) / static_cast<double>(programmed.size() + 1);
      const double share = whole > 0 ? arc_length_mm(from, {from.move + k, 1}) / whole : even;
      if (line.is_defined()) straight.push_back(line.at(std::clamp(share, 0.0, 1.0)));
      above.push_back(lifted(programmed[k], lift));
    }
    straight.push_back(down);
    above.push_back(down);
    bool is_kept_near = false;
    for (std::size_t i = from.move; i <= to.move; ++i) is_kept_near = is_kept_near || was_clean(i);
    const CheckOptions options = options_for(is_kept_near, clearance);
    // In a feed that keeps the clearance, the cutter keeps it too.
    const auto crosses = [&](const Pose& a, const Pose& b, MoveKind kind) {
      const Motion motion = options.law.between(a, b, kind);
      return motion.is_defined() &&
             job_.checker.is_clean(motion, clearance > 0 ? MoveKind::rapid : kind, tool_, options, true);
    };
    const auto is_free = [&](const std::vector<Pose>& way) {
      Pose at = up;
      for (std::size_t k = 0; k < way.size(); ++k) {
        if (!crosses(at, way[k], is_rapid ? MoveKind::rapid : move(from.move + k).kind)) return false;
        at = way[k];
      }
      return true;
    };
    const bool is_line_one = options.law.is_divisible(MoveKind::rapid);
    const bool is_straight =
        line.is_defined() &&
        (is_line_one ? crosses(up, down, is_rapid ? MoveKind::rapid : MoveKind::feed) : is_free(straight));
    if (!is_straight && (programmed.empty() || !is_free(above))) return std::nullopt;
    return trim_over(from, to, is_straight ? straight : above, is_rapid, lift);
  }

  [[nodiscard]] bool is_clean(const Pose& from, const Pose& to, MoveKind kind, const CheckOptions& options) const {
    const Motion motion = options.law.between(from, to, kind);
    return motion.is_defined() && job_.checker.is_clean(motion, kind, tool_, options, true);
  }

  [[nodiscard]] Trim trim_over(const PathPlace& from, const PathPlace& to, const std::vector<Pose>& way, bool is_rapid,
                               double lift) const {
    Trim trim;
    trim.begin = from;
    trim.end = to;
    trim.lift_mm = lift;
    const Pose begin = pose(from), end = pose(to);
    const auto visit = [&](std::size_t i, bool is_end, const Pose& where, const Pose& was, bool at_rapid) {
      trim.positions.push_back({i, is_end, where, at_rapid ? MoveKind::rapid : move(i).kind});
      trim.programmed.push_back(was);
    };
    if (from.t > 0) visit(from.move, false, begin, begin, false);
    if (!is_on_rapid(from)) visit(from.move, false, lifted(begin, lift), begin, false);
    for (std::size_t i = from.move; i < to.move; ++i) visit(i, true, way[i - from.move], move(i).end, is_rapid);
    if (!is_on_rapid(to)) visit(to.move, false, way.back(), end, is_rapid);
    if (to.t < 1) visit(to.move, false, end, end, false);
    trim.uncut_positions = to.move - from.move;
    for (std::size_t i = from.move; i <= to.move; ++i) {
      if (move(i).kind == MoveKind::rapid) continue;
      trim.uncut_mm += arc_length_mm(i == from.move ? from : PathPlace{i, 0}, i == to.move ? to : PathPlace{i, 1});
    }
    return trim;
  }

  const TrimJob& job_;
  const ToolVariants& tool_;
  std::size_t first_, last_;
  std::vector<FreeStretch> free_;
};

bool is_trimmable(const TrimJob& job, std::size_t i) {
  const Move& move = job.path.moves[i];
  const MoveState state = job.result.verdicts[i].state;
  return (move.kind == MoveKind::feed || move.kind == MoveKind::rapid) && move.curve_kind == CurveKind::none &&
         state != MoveState::not_checked && state != MoveState::not_certified && move.not_checked_reason.empty() &&
         move.tool != kNone && job.tools[move.tool] != nullptr;
}

}  // namespace

TrimPlan plan_trims(const TrimJob& job) {
  const Moves& moves = job.path.moves;
  TrimPlan plan;
  for (std::size_t first = 0, last = 0; first < moves.size(); first = last) {
    last = first + 1;
    if (!is_trimmable(job, first)) {
      if (job.is_wanted[first]) plan.failed.push_back({first, first, "not left out: only straight moves are"});
      continue;
    }
    bool is_any = job.is_wanted[first];
    for (; last < moves.size() && moves[last].has_start && is_trimmable(job, last) &&
           moves[last].tool == moves[first].tool;
         ++last)
      is_any = is_any || job.is_wanted[last];
    if (is_any) TrimChain(job, first, last).plan(plan);
  }
  return plan;
}

}  // namespace gouge

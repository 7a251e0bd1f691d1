#include "lib/tilt/plan_tilts.h"

#include <algorithm>
#include <cmath>

#include "lib/base/number_text.h"
#include "lib/base/tolerance.h"
#include "lib/base/units.h"
#include "lib/path/path_info.h"
#include "lib/tilt/closed_contours.h"
#include "lib/tilt/cut_path.h"
#include "lib/tilt/smooth_tilts.h"
#include "lib/tilt/untilted_reason.h"

namespace gouge {
namespace {

constexpr double kStepsPerBlend = 8;
constexpr double kMaxSpacing_mm = 5, kMinSpacing_mm = 0.2;
constexpr int kFinerSpacings = 2;  // number of retries of a run, each with half the spacing
constexpr int kSlowerBlends = 5;   // maximum number of times that the blend is doubled if the tool turns too fast
constexpr double kStraight_rad =
    0.005 * kDegree_rad;  // an added position closer to the line between its neighbours is left out

double spacing_mm(const TiltOptions& options) {
  return std::clamp(options.blend_mm / kStepsPerBlend, kMinSpacing_mm, kMaxSpacing_mm);
}

/// Returns the largest tilt of a lattice. If the cone or the machine permits small tilts alone, a lattice over all tilts
/// up to --max-tilt would have few of them.
double widest_rad(const std::vector<TiltPosition>& positions, const TiltOptions& options) {
  constexpr std::size_t kSamples = 16;
  constexpr double kFew = 0.25;
  if (!options.cone && options.reach == nullptr) return options.max_tilt_rad;
  TiltTask task;
  task.options = options;
  const TiltSpace space(positions, task);
  double widest = 0;
  for (std::size_t k = 0; k < kSamples; ++k) {
    const std::size_t i = k * (space.size() - 1) / (kSamples - 1);
    for (const Tilt& direction : tilt_directions(options.freedom)) {
      widest = std::max(widest, space.largest_permitted_rad(i, direction));
      if (widest > kFew * options.max_tilt_rad) return options.max_tilt_rad;
    }
  }
  return widest > 0 ? widest : options.max_tilt_rad;
}

class RunPlanner {
 public:
  RunPlanner(const TiltJob& job, const TiltRun& run, CutPath& cut, ClosedContours& contours)
      : job_(job), run_(run), cut_(cut), contours_(contours) {}

  /// Tries to tilt the run. Returns whether a tilt was found; otherwise `reason` states why not. If the tilt would
  /// leave stock on finished surfaces, plan() also tries two restricted tilts. One is only forward and back, which
  /// leaves the least under a flat end; the other is only to the sides.
  bool plan() {
    const bool is_free_way = job_.options.freedom == TiltFreedom::both;
    if (plan_with(job_.options.freedom)) return true;
    for (const TiltFreedom freedom : {TiltFreedom::lead, TiltFreedom::side}) {
      if (min_stock_ && is_free_way && plan_with(freedom)) return true;
    }
    if (min_stock_) reason = stock_reason();
    is_leaving = min_stock_.has_value();
    return false;
  }

  SmoothedRun tilted;
  std::string reason;
  bool is_blocked = false;                       ///< at some position no tilt is free
  bool is_leaving = false;                       ///< tilts exist, but they leave stock on finished surfaces
  bool is_too_fast = false, is_too_far = false;  ///< tilts exist, but they turn faster or further than allowed

 private:
  bool plan_with(TiltFreedom freedom) {
    TiltOptions options = job_.options;
    options.freedom = freedom;
    const std::vector<TiltPosition> positions =
        freedom == job_.options.freedom ? run_.positions : with_freedom(run_, freedom).positions;
    options.max_tilt_rad = widest_rad(positions, options);
    std::optional<std::size_t> doubtful;
    std::vector<KnownTilts> known;
    for (const bool may_raise : {false, true}) {
      const TiltTask task{job_.tools[run_.tool], &job_.checker, options, may_raise};
      LatticeResult found;
      std::optional<Tilted> way = where_known(positions, task);
      if (!way) way = look_for(TiltSpace(positions, task), doubtful, known, found);
      if (way) {
        close_contours(*way);
        if (!keeps_turns(*way) || leaves_too_much(way->space, way->tilts)) return false;
        gather(way->space, way->tilts);
        cut_.accept(way->space, way->tilts);
        contours_.learn(way->space, way->tilts);
        return true;
      }
      if (!may_raise || found.blocked) reason = untilted_reason(job_, TiltSpace(positions, task), found);
      if (found.held_back) return false;  // raising the tip does not help
      doubtful = found.blocked;
    }
    is_blocked = doubtful.has_value();
    return false;
  }

  struct Tilted {
    TiltSpace space;
    TiltSequence tilts;
  };

  [[nodiscard]] std::optional<Tilted> look_for(TiltSpace space, std::optional<std::size_t> doubtful,
                                               std::vector<KnownTilts>& learned, LatticeResult& found) const {
    const unsigned threads = job_.checker.options().threads;
    found = find_tilts(space, threads, doubtful, learned);
    if (!found.sequence) return std::nullopt;
    TiltSequence tilts = smooth_tilts(space, *found.sequence, threads);
    return Tilted{std::move(space), std::move(tilts)};
  }

  // Searches with the tilts of other runs at contours that close between the runs. If this finds nothing, the contour
  // opens.
  [[nodiscard]] std::optional<Tilted> where_known(const std::vector<TiltPosition>& positions,
                                                  const TiltTask& task) const {
    LatticeResult found;
    std::vector<KnownTilts> learned;
    std::optional<std::vector<TiltPosition>> known = contours_.with_known(positions);
    return known ? look_for(TiltSpace(std::move(*known), task), std::nullopt, learned, found) : std::nullopt;
  }

  // Handles contours with both ends in the run but with different tilts. Gives both ends the tilt of the first one or
  // else of the second one.
  void close_contours(Tilted& way) const {
    const auto axis_at = [&](std::size_t i) { return way.space[i].axis_for(way.tilts[i]); };
    for (const auto& [begin, end] : contours_.loops(way.space)) {
      if (angle_between_rad(axis_at(begin), axis_at(end)) < Tolerance::kSameDirection) continue;
      for (const std::size_t as : {begin, end}) {
        const std::size_t other_end = begin + end - as;
        if (way.space[other_end].is_fixed()) continue;
        std::vector<TiltPosition> closed;
        for (std::size_t i = 0; i < way.space.size(); ++i) closed.push_back(way.space[i]);
        closed[as].given = way.tilts[as];
        closed[other_end].given = closed[other_end].tilt_to(axis_at(as));
        LatticeResult found;
        std::vector<KnownTilts> learned;
        std::optional<Tilted> other =
            look_for(TiltSpace(std::move(closed), way.space.task()), std::nullopt, learned, found);
        if (!other || beyond_limits(*other).is_any()) continue;
        way = std::move(*other);
        break;
      }
    }
  }

  /// The limits of turns that a sequence exceeds.
  struct Beyond {
    bool is_too_fast = false, is_too_far = false;
    [[nodiscard]] bool is_any() const { return is_too_fast || is_too_far; }
  };
  [[nodiscard]] Beyond beyond_limits(const Tilted& way) const {
    Beyond beyond;
    for (std::size_t i = 0; i + 1 < way.space.size(); ++i) {
      if (way.space.may_turn(i, way.tilts[i], i + 1, way.tilts[i + 1])) continue;
      const double turn =
          angle_between_rad(way.space[i].axis_for(way.tilts[i]), way.space[i + 1].axis_for(way.tilts[i + 1]));
      (turn > job_.options.max_turn_step_rad ? beyond.is_too_far : beyond.is_too_fast) = true;
    }
    return beyond;
  }

  // If it is unknown whether stock is left, the tilt is used. The alternative is a lift, which certainly leaves stock.
  // The report of left stock states that it is unknown.
  bool leaves_too_much(const TiltSpace& space, const TiltSequence& tilts) {
    const std::optional<LeftStock> left = cut_.left_by(space, tilts);
    if (!left || !left->is_proved) return false;
    if (!min_stock_ || left->thickness_mm < min_stock_->thickness_mm) {
      min_stock_ = left;
      stock_tilt_rad_ = 0;
      for (const Tilt& tilt : tilts) stock_tilt_rad_ = std::max(stock_tilt_rad_, tilt.norm());
    }
    return true;
  }

  [[nodiscard]] std::string stock_reason() const {
    const double unit_mm = mm_per(job_.path.unit);
    const int digits = job_.path.unit == LengthUnit::mm ? 3 : 4;
    const auto length = [&](double mm) { return display_text(mm / unit_mm, digits); };
    const auto& witness = job_.result.verdicts[run_.first_wanted].witness;
    const Vec3& at = min_stock_->point;
    return std::string("the ") + body_name(witness ? witness->body : Body::holder) +
           " collides; the tilt that frees it and leaves least (" + display_text(stock_tilt_rad_ / kDegree_rad, 1) +
           " degrees) " + "would leave " + length(min_stock_->thickness_mm) + " " + unit_name(job_.path.unit) +
           (min_stock_->is_more ? " or more" : "") + " of stock at (" + length(at.x()) + ", " + length(at.y()) + ", " +
           length(at.z()) + "), which the programmed path finished (--allow-stock)";
  }

  bool keeps_turns(const Tilted& way) {
    const Beyond beyond = beyond_limits(way);
    is_too_fast = is_too_fast || beyond.is_too_fast;
    is_too_far = is_too_far || beyond.is_too_far;
    if (is_too_fast) reason = "the tool would have to turn faster than --max-turn allows";
    if (is_too_far) reason = "the tool would have to turn further in a record than --max-turn-step allows";
    return !is_too_fast && !is_too_far;
  }

  void gather(const TiltSpace& space, const TiltSequence& tilts) {
    tilted.first_wanted = run_.first_wanted;
    tilted.last_wanted = run_.last_wanted;
    std::size_t last_kept = 0;
    for (std::size_t i = 0; i < space.size(); ++i) {
      const TiltPosition& at = space[i];
      const bool is_end = !(at.t < 1), is_first = i == 0, is_last = i + 1 == space.size();
      const bool is_untilted = tilts[i].norm() <= Tolerance::kSameDirection;
      if (!is_end && !is_first && !is_last && is_needless(space, tilts, last_kept, i)) continue;
      last_kept = i;
      // If a run begins at the start of a move, that position is the end of the move before, which does not change.
      if (is_first && !(at.t > 0)) continue;
      if (is_end && is_untilted) continue;
      const Pose pose = *space.pose(i, tilts[i]);
      tilted.positions.push_back(
          {at.move, is_end, at.programmed, pose, angle_between_rad(pose.axis, at.programmed.axis)});
    }
  }

  /// Returns whether a straight motion from the last kept position to the next position needs no position in between.
  [[nodiscard]] bool is_needless(const TiltSpace& space, const TiltSequence& tilts, std::size_t from,
                                 std::size_t i) const {
    const std::size_t to = i + 1;
    const double whole = space[to].arc_length_mm - space[from].arc_length_mm;
    if (!(whole > 0)) return false;
    for (std::size_t k = from + 1; k <= i; ++k) {
      const double share = (space[k].arc_length_mm - space[from].arc_length_mm) / whole;
      if ((tilts[k] - tilts[from] - share * (tilts[to] - tilts[from])).norm() > kStraight_rad) return false;
    }
    return space.may_turn(from, tilts[from], to, tilts[to]) && space.is_free_between(from, tilts[from], to, tilts[to]);
  }

  const TiltJob& job_;
  const TiltRun& run_;
  CutPath& cut_;
  ClosedContours& contours_;
  std::optional<LeftStock> min_stock_;  // of the tilts that leave too much
  double stock_tilt_rad_ = 0;
};

/// A plan, and the limits of turns that its runs exceed.
struct Attempt {
  TiltPlan plan;
  bool is_too_fast = false, is_too_far = false;
};

/// Plans with positions that are `spacing_mm` apart. Runs without a result are retried with closer positions.
Attempt attempt(const TiltJob& job, double spacing_mm, const ProgressCall& progress) {
  Attempt made;
  TiltPlan& plan = made.plan;
  CutPath cut(job);
  ClosedContours contours(job);
  std::vector<bool> is_left = job.is_wanted;
  for (int round = 0; round <= kFinerSpacings; ++round, spacing_mm /= 2) {
    const std::vector<TiltRun> runs =
        find_tilt_runs({job.path, job.result, job.tools, job.checker, job.options, is_left, job.origin}, spacing_mm);
    std::erase_if(plan.failed, [&](const UntiltedRun& run) { return is_left[run.first_wanted]; });
    contours.begin(runs);
    for (std::size_t r = 0; r < runs.size(); ++r) {
      if (progress) progress("tilting the tool", r, runs.size());
      RunPlanner planner(job, runs[r], cut, contours);
      const bool is_planned = planner.plan();
      if (is_planned) plan.runs.push_back(std::move(planner.tilted));
      if (!is_planned) plan.failed.push_back({runs[r].first_wanted, runs[r].last_wanted, planner.reason});
      made.is_too_fast = made.is_too_fast || planner.is_too_fast;
      made.is_too_far = made.is_too_far || planner.is_too_far;
      const bool is_done =
          is_planned || planner.is_blocked || planner.is_leaving || planner.is_too_fast || planner.is_too_far;
      for (std::size_t i = runs[r].first_wanted; i <= runs[r].last_wanted && is_done; ++i) is_left[i] = false;
    }
    if (runs.empty()) break;
  }
  std::ranges::sort(plan.runs, {}, &SmoothedRun::first_wanted);
  return made;
}

}  // namespace

TiltPlan plan_tilts(const TiltJob& job, const ProgressCall& progress) {
  TiltOptions options = job.options;
  double spacing = spacing_mm(options);
  std::optional<TiltPlan> best;
  for (int k = 0; k <= kSlowerBlends; ++k) {
    Attempt made =
        attempt({job.path, job.result, job.tools, job.checker, options, job.is_wanted, job.origin}, spacing, progress);
    if (!best || made.plan.failed.size() < best->failed.size()) best = std::move(made.plan);
    // A longer blend makes the tool turn slower. Closer positions make it turn less from one position to the next.
    if (!made.is_too_fast && !made.is_too_far) break;
    if (made.is_too_fast) options.blend_mm *= 2;
    if (made.is_too_far) spacing = std::max(spacing / 2, kMinSpacing_mm / 4);
  }
  return *best;
}

}  // namespace gouge

#include "lib/tilt/plan_tilts.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lib/base/number_text.h"
#include "lib/path/path_info.h"
#include "lib/tilt/smooth_tilts.h"

namespace gouge {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kStepsPerBlend = 8;
constexpr double kMostSpacing_mm = 5, kLeastSpacing_mm = 0.2;
constexpr int kFinerSpacings = 2;                  // how often a run is tried again with half the spacing
constexpr double kStraight_rad = 0.005 * kDegree;  // an added position whose tilt is that of its neighbours is left out
constexpr double kSame_rad = 1e-9;

double spacing_mm(const TiltOptions& options) {
  return std::clamp(options.blend_mm / kStepsPerBlend, kLeastSpacing_mm, kMostSpacing_mm);
}

class RunPlanner {
 public:
  RunPlanner(const TiltJob& job, const TiltRun& run) : job_(job), run_(run) {}

  /// True where a tilt was found; else `reason` says why not.
  bool plan() {
    std::optional<std::size_t> doubtful;
    for (const bool may_raise : {false, true}) {
      const TiltSpace space(run_.positions, {job_.tools[run_.tool], &job_.checker, job_.options, may_raise});
      const LatticeResult found = find_tilts(space, run_.open, job_.checker.options().threads, doubtful);
      if (found.sequence) {
        const TiltSequence tilts = smooth_tilts(space, *found.sequence, run_.open, job_.checker.options().threads);
        gather(space, tilts);
        return true;
      }
      if (!may_raise || found.blocked) reason = why_not(space, found);
      doubtful = found.blocked;
    }
    is_blocked = doubtful.has_value();
    return false;
  }

  SmoothedRun tilted;
  std::string reason;
  bool is_blocked = false;  ///< at some position no tilt is free

 private:
  void gather(const TiltSpace& space, const TiltSequence& tilts) {
    tilted.first_wanted = run_.first_wanted;
    tilted.last_wanted = run_.last_wanted;
    std::size_t last_kept = 0;
    for (std::size_t i = 0; i < space.size(); ++i) {
      const TiltPosition& at = space[i];
      const bool is_end = !(at.t < 1), is_first = i == 0, is_last = i + 1 == space.size();
      const bool is_untilted = tilts[i].norm() <= kSame_rad;
      if (!is_end && !is_first && !is_last && is_needless(space, tilts, last_kept, i)) continue;
      last_kept = i;
      // The start of a run that is the start of a move is the end of the one before it, which stays.
      if (is_first && !(at.t > 0)) continue;
      if (is_end && is_untilted) continue;
      const Pose pose = *space.pose(i, tilts[i]);
      tilted.positions.push_back(
          {at.move, is_end, at.programmed, pose, angle_between_rad(pose.axis, at.programmed.axis)});
    }
  }

  /// Whether the straight motion from the last position kept to the next one needs none between.
  [[nodiscard]] bool is_needless(const TiltSpace& space, const TiltSequence& tilts, std::size_t from,
                                 std::size_t i) const {
    const std::size_t to = i + 1;
    const double whole = space[to].way_mm - space[from].way_mm;
    if (!(whole > 0)) return false;
    for (std::size_t k = from + 1; k <= i; ++k) {
      const double share = (space[k].way_mm - space[from].way_mm) / whole;
      if ((tilts[k] - tilts[from] - share * (tilts[to] - tilts[from])).norm() > kStraight_rad) return false;
    }
    return space.is_free_between(from, tilts[from], to, tilts[to]);
  }

  [[nodiscard]] std::string why_not(const TiltSpace& space, const LatticeResult& found) const {
    const std::string most = people_text(job_.options.max_tilt_rad / kDegree, 3) + " degrees";
    if (!found.blocked)
      return "tilts within --max-tilt " + most + " are free at each position, but no way leads between them";
    // What is in the way at the least.
    const TiltPosition& at = space[*found.blocked];
    MoveVerdict least = space.verdict(*found.blocked, Tilt::Zero());
    constexpr int kRings = 6, kAround = 12;
    for (int ring = 1; ring <= kRings; ++ring) {
      for (int k = 0; k < kAround; ++k) {
        const double angle = k * 2 * std::numbers::pi / kAround;
        const double tilt = ring * job_.options.max_tilt_rad / kRings;
        if (job_.options.freedom == TiltFreedom::lead && k % (kAround / 2) != 0) continue;
        if (job_.options.freedom == TiltFreedom::side && k % (kAround / 2) != kAround / 4) continue;
        const MoveVerdict verdict = space.verdict(*found.blocked, tilt * Tilt(std::cos(angle), std::sin(angle)));
        if (verdict.state == MoveState::gouge && verdict.depth_mm < least.depth_mm) least = verdict;
      }
    }
    const Body body = least.witness ? least.witness->body : Body::holder;
    return "no tilt within --max-tilt " + most + " frees line " + std::to_string(job_.path.moves[at.move].line) +
           ": at the best one looked at the " + body_name(body) + " is " + people_text(least.depth_mm, 3) +
           " mm too deep";
  }

  const TiltJob& job_;
  const TiltRun& run_;
};

}  // namespace

TiltPlan plan_tilts(const TiltJob& job, const ProgressCall& progress) {
  TiltPlan plan;
  std::vector<bool> is_left = job.is_wanted;
  double spacing = spacing_mm(job.options);
  for (int round = 0; round <= kFinerSpacings; ++round, spacing /= 2) {
    const std::vector<TiltRun> runs =
        find_tilt_runs({job.path, job.result, job.tools, job.checker, job.options, is_left}, spacing);
    std::erase_if(plan.failed, [&](const UntiltedRun& run) { return is_left[run.first_wanted]; });
    for (std::size_t r = 0; r < runs.size(); ++r) {
      if (progress) progress("tilting the tool", r, runs.size());
      RunPlanner planner(job, runs[r]);
      if (planner.plan()) {
        plan.runs.push_back(std::move(planner.tilted));
        for (std::size_t i = runs[r].first_wanted; i <= runs[r].last_wanted; ++i) is_left[i] = false;
      } else {
        plan.failed.push_back({runs[r].first_wanted, runs[r].last_wanted, planner.reason});
        // There no finer positions help.
        for (std::size_t i = runs[r].first_wanted; i <= runs[r].last_wanted && planner.is_blocked; ++i)
          is_left[i] = false;
      }
    }
    if (runs.empty()) break;
  }
  std::ranges::sort(plan.runs, {}, &SmoothedRun::first_wanted);
  return plan;
}

}  // namespace gouge

#include "lib/correct/correct_path.h"

#include <algorithm>
#include <mutex>

#include "lib/base/parallel.h"
#include "lib/correct/bridge.h"
#include "lib/correct/straighten.h"

namespace gouge {
namespace {

constexpr std::size_t kPositionsPerChunk = 4;
// A correction aims at half the tolerance: the other half is for the rounding of the written numbers and for
// the motion between corrected positions. What has no business at a surface, fixtures and bodies that must keep a
// clearance, gets this much air.
constexpr double kAimShare = 0.5;
constexpr double kAir_mm = 2e-3;
// While bridging, motions are held to this share of the tolerance.
constexpr double kBridgeShare = 0.8;

constexpr const char* kToolBuried = "the tool is buried: there is no way out to follow";
constexpr const char* kHeadBuried = "the head is buried: there is no way out to follow";
constexpr const char* kNoWayBetween = "no clean way between its positions within the largest shift";
constexpr const char* kHeadStays =
    "the head is in the way: no lift along the tool axis within the largest shift frees it; it takes another "
    "tilt or a "
    "longer tool";
constexpr const char* kHeadBetween =
    "the head is in the way between its positions: no clean way within the largest shift; it takes another "
    "tilt or a "
    "longer tool";

struct PositionWork {
  bool is_wanted = false;
  std::optional<CorrectedPose> corrected;
  std::string failure;
  double depth_before_mm = 0, depth_after_mm = 0;
};

struct MoveWork {
  bool is_wanted = false;
  std::vector<BridgePose> inserted;
  bool is_failed = false;
};

class PathCorrector {
 public:
  PathCorrector(const Toolpath& toolpath, const CheckResult& result,
                const std::vector<const ToolForms*>& tools, const PreparedScene& scene,
                const CheckOptions& options, const CorrectOptions& correct)
      : path_(toolpath), result_(result), tools_(tools), scene_(scene), options_(options), correct_(correct) {
    const double cut = options.tolerance_mm > 2 * kAir_mm ? kAimShare * options.tolerance_mm : -kAir_mm;
    limits_.aim = {cut, -kAir_mm, -kAir_mm};
    limits_.largest_shift_mm = correct.max_shift_mm;
    limits_.heads = correct.heads;
    positions_.resize(path_.moves.size());
    moves_.resize(path_.moves.size());
  }

  Correction run(const ProgressCall& progress) {
    choose_positions();
    work(positions_, progress, [this](std::size_t i) { correct_position(i); });
    choose_moves();
    work(moves_, progress, [this](std::size_t i) { bridge_move(i); });
    return gather();
  }

 private:
  [[nodiscard]] bool is_chained(std::size_t i) const {
    return path_.moves[i].has_start && path_.moves[i].tool == path_.moves[i - 1].tool;
  }

  [[nodiscard]] static bool is_straight(const Move& move) {
    return move.kind == MoveKind::feed || move.kind == MoveKind::rapid;
  }

  [[nodiscard]] std::string reason_to_leave(std::size_t i) const {
    if (!is_straight(path_.moves[i])) return "the position ends an arc or a cycle step";
    const bool is_arc_next =
        i + 1 < path_.moves.size() && path_.moves[i + 1].has_start && !is_straight(path_.moves[i + 1]);
    return is_arc_next ? "an arc or a step of a cycle begins at the position" : "";
  }

  void choose_positions() {
    for (std::size_t i = 0; i < path_.moves.size(); ++i) {
      if (result_.verdicts[i].state != MoveState::gouge) continue;
      positions_[i].is_wanted = true;
      if (is_chained(i)) positions_[i - 1].is_wanted = true;
    }
  }

  void correct_position(std::size_t i) {
    PositionWork& work = positions_[i];
    const Move& move = path_.moves[i];
    if (move.tool == kNone || tools_[move.tool] == nullptr) return;
    const ToolForms& tool = *tools_[move.tool];
    work.depth_before_mm = depth_at(move.end, move.kind, tool);
    // A position within the tolerance is left alone, even one deeper than a correction aims for.
    const double within = kBridgeShare * options_.tolerance_mm;
    const CorrectionAim allowed{within, within, 0};
    PoseLimits now = limits_;
    now.aim = allowed;
    const bool is_head_in = head_excess(move.end, now) > 0;
    if (!is_head_in && largest_excess(move.end, tool, scene_, allowed, options_.resolution_mm / 4) <= 0)
      return;
    work.failure = reason_to_leave(i);
    if (!work.failure.empty()) return;
    if (move.kind == MoveKind::rapid) {
      now.aim = {-correct_.rapid_clearance_mm, -correct_.rapid_clearance_mm, -kAir_mm};
      work.corrected = correct_pose(correct_.strategy, move.end, tool, scene_, now);
    }
    if (!work.corrected) work.corrected = correct_pose(correct_.strategy, move.end, tool, scene_, limits_);
    if (!work.corrected) {
      work.failure = is_head_in ? kHeadStays : "no way out within the largest shift";
      return;
    }
    work.depth_after_mm = depth_at(work.corrected->pose, move.kind, tool);
  }

  // As deep as it is, not only whether that is too deep.
  [[nodiscard]] double depth_at(const Pose& pose, MoveKind kind, const ToolForms& tool) const {
    CheckOptions exact = options_;
    exact.tolerance_mm = 0;
    MoveVerdict verdict = check_move(Motion(pose), kind, tool, scene_, exact);
    if (correct_.heads != nullptr) correct_.heads->check(Motion(pose), exact, verdict);
    return verdict.depth_mm;
  }

  void choose_moves() {
    for (std::size_t i = 0; i < path_.moves.size(); ++i) {
      const Move& move = path_.moves[i];
      if (!move.has_start || !is_straight(move) || !move.not_checked_reason.empty()) continue;
      const bool is_gouging = result_.verdicts[i].state == MoveState::gouge;
      const bool has_new_end = positions_[i].corrected || (is_chained(i) && positions_[i - 1].corrected);
      moves_[i].is_wanted = is_gouging || has_new_end;
    }
  }

  [[nodiscard]] Pose end_of(std::size_t i) const {
    return positions_[i].corrected ? positions_[i].corrected->pose : path_.moves[i].end;
  }

  void bridge_move(std::size_t i) {
    const Move& move = path_.moves[i];
    const bool has_bad_end =
        !positions_[i].failure.empty() || (is_chained(i) && !positions_[i - 1].failure.empty());
    if (has_bad_end) {
      moves_[i].is_failed = true;
      return;
    }
    BridgeTask task;
    task.kind = move.kind;
    task.tool = tools_[move.tool];
    task.scene = &scene_;
    task.options = options_;
    task.options.near_miss_mm = 0;
    task.options.tolerance_mm = kBridgeShare * options_.tolerance_mm;
    task.limits = limits_;
    task.strategy = correct_.strategy;
    task.rapid_clearance_mm = correct_.rapid_clearance_mm;
    auto way = bridge(is_chained(i) ? end_of(i - 1) : path_.start_of(i), end_of(i), task);
    moves_[i].is_failed = !way;
    if (way) moves_[i].inserted = std::move(*way);
  }

  template <class Work, class Do>
  void work(std::vector<Work>& all, const ProgressCall& progress, Do&& what) {
    std::vector<std::size_t> wanted;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (all[i].is_wanted) wanted.push_back(i);
    }
    std::mutex told;
    std::size_t done = 0;
    for_each_chunk(wanted.size(), kPositionsPerChunk, options_.threads,
                   [&](std::size_t first, std::size_t last) {
                     for (std::size_t k = first; k < last; ++k) what(wanted[k]);
                     if (!progress) return;
                     const std::scoped_lock lock(told);
                     done += last - first;
                     progress(done, wanted.size());
                   });
  }

  Correction gather() const {
    Correction correction;
    for (std::size_t i = 0; i < path_.moves.size(); ++i) {
      gather_records(i, correction);
      PathChange change;
      change.move = i;
      if (positions_[i].corrected) change.new_end = positions_[i].corrected->pose;
      for (const BridgePose& stop : moves_[i].inserted) change.inserted_before.push_back(stop.corrected.pose);
      if (change.new_end || !change.inserted_before.empty()) correction.changes.push_back(change);
      gather_failure(i, correction);
    }
    return correction;
  }

  void gather_records(std::size_t i, Correction& correction) const {
    for (const BridgePose& stop : moves_[i].inserted) {
      const double after = depth_at(stop.corrected.pose, path_.moves[i].kind, *tools_[path_.moves[i].tool]);
      correction.records.push_back({i, stop.corrected.strategy, true,
                                    stop.corrected.pose.tip - stop.before.tip, stop.depth_before_mm, after,
                                    stop.corrected.iterations});
    }
    const PositionWork& p = positions_[i];
    if (!p.corrected) return;
    correction.records.push_back({i, p.corrected->strategy, false,
                                  p.corrected->pose.tip - path_.moves[i].end.tip, p.depth_before_mm,
                                  p.depth_after_mm, p.corrected->iterations});
  }

  void gather_failure(std::size_t i, Correction& correction) const {
    const MoveVerdict& verdict = result_.verdicts[i];
    const bool is_position_failed = !positions_[i].failure.empty();
    if (verdict.state == MoveState::buried) {
      const bool is_head = verdict.reason == kHeadIsBuried;
      correction.uncorrected.push_back({i, 0, is_head ? kHeadBuried : kToolBuried});
    } else if (is_position_failed && verdict.state == MoveState::gouge) {
      correction.uncorrected.push_back({i, verdict.depth_mm, positions_[i].failure});
    } else if (moves_[i].is_failed) {
      const bool is_head = verdict.witness && verdict.witness->body == Body::head;
      correction.uncorrected.push_back({i, verdict.depth_mm, is_head ? kHeadBetween : kNoWayBetween});
    }
  }

  const Toolpath& path_;
  const CheckResult& result_;
  const std::vector<const ToolForms*>& tools_;
  const PreparedScene& scene_;
  const CheckOptions& options_;
  const CorrectOptions& correct_;
  PoseLimits limits_;
  std::vector<PositionWork> positions_;
  std::vector<MoveWork> moves_;
};

}  // namespace

Correction correct_path(const Toolpath& toolpath, const CheckResult& result,
                        const std::vector<const ToolForms*>& tools, const PreparedScene& scene,
                        const CheckOptions& options, const CorrectOptions& correct,
                        const ProgressCall& progress) {
  if (!needs_straightening(toolpath, result)) {
    return PathCorrector(toolpath, result, tools, scene, options, correct).run(progress);
  }
  const StraightenedPath straight = straighten(toolpath, result, tools, scene, options, correct.heads);
  PathCorrector corrector(straight.path, straight.result, tools, scene, options, correct);
  return restore_curves(straight, toolpath, result, corrector.run(progress));
}

}  // namespace gouge

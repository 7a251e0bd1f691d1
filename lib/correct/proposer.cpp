#include "lib/correct/proposer.h"

#include <algorithm>

#include "lib/correct/keep_arcs.h"
#include "lib/correct/straighten.h"
#include "lib/correct/tilt_path.h"

namespace gouge {
namespace {

constexpr const char* kNoAxes =
    "the file states no tool axes, it is of three axes, so nothing is tilted; --allow-multax lets a correction add them";

template <typename Thing>
void sort_by_move(std::vector<Thing>& things) {
  std::ranges::stable_sort(things, {}, &Thing::move);
}

}  // namespace

Proposer::Proposer(const Toolpath& path, const CheckResult& result, const CheckSetup& setup,
                   const CorrectOptions& correct, const ProgressCall& progress)
    : path_(path), result_(result), tools_(setup.tools), checker_(setup), correct_(correct) {
  if (correct.rewritable != nullptr) can_keep_arc_ = correct.rewritable->arc;
  if (correct.rewritable != nullptr) can_split_ = correct.rewritable->split;
  can_split_.resize(path.moves.size(), false);
  plan_tilting(progress);
  rework();
  holes_ = plan_holes(path, result, tools_, checker_, correct);
}

void Proposer::plan_tilting(const ProgressCall& progress) {
  const std::vector<bool> is_wanted = moves_to_tilt(path_, result_, correct_.strategies);
  const bool has_axes = correct_.rewritable == nullptr || correct_.rewritable->has_axes || correct_.may_add_axes;
  const bool is_any = std::ranges::find(is_wanted, true) != is_wanted.end();
  const auto near = is_any && has_axes ? moves_near(path_, is_wanted, correct_.tilt.blend_mm) : std::vector<bool>();
  straight_ = straighten(path_, result_, tools_, checker_, near);
  if (!is_any) return;
  const ReworkedPath* const base = straight_ ? &*straight_ : nullptr;
  const Toolpath& path = base != nullptr ? base->path : path_;
  const CheckResult& result = base != nullptr ? base->result : result_;
  const std::vector<bool> is_wanted_here = moves_to_tilt(path, result, correct_.strategies);
  if (has_axes) {
    plan_ = plan_tilts({path, result, tools_, checker_, correct_.tilt, is_wanted_here}, progress);
    return;
  }
  for (std::size_t i = 0; i < is_wanted_here.size(); ++i) {
    if (is_wanted_here[i]) plan_.failed.push_back({i, i, kNoAxes});
  }
}

void Proposer::rework() {
  tilted_.reset();
  if (!plan_.runs.empty()) tilted_ = tilt_path(path_, result_, straight_, plan_, tools_, checker_);
  const ReworkedPath* const last = tilted_ ? &*tilted_ : straight_ ? &*straight_ : nullptr;
  corrector_ = std::make_unique<PathCorrector>(last != nullptr ? last->path : path_,
                                               last != nullptr ? last->result : result_, tools_, checker_, correct_);
  for (const auto& [move, reason] : kept_) keep_pieces(move, reason);
}

Correction Proposer::propose(const ProgressCall& progress) {
  Correction correction = corrector_->propose(progress);
  if (tilted_ || straight_) {
    correction = restore_moves(tilted_ ? *tilted_ : *straight_, path_, result_, std::move(correction));
    if (!can_keep_arc_.empty()) keep_arcs({path_, tools_, checker_, correct_, can_keep_arc_, can_split_}, correction);
  }
  add_tilts(correction);
  add_holes(correction);
  return correction;
}

bool Proposer::give_up_arc(const std::vector<PathChange>& changes, std::size_t move) {
  const bool was_arc = std::any_of(changes.begin(), changes.end(),
                                   [move](const PathChange& c) { return c.move == move && c.has_arc(); });
  if (was_arc) can_keep_arc_[move] = false;
  return was_arc;
}

void Proposer::keep(std::size_t move, const std::string& reason) {
  std::erase_if(holes_, [move](const HolePlan& hole) { return move + 1 >= hole.first && move <= hole.last; });
  if (give_up_tilt(move, reason)) return rework();
  kept_.emplace_back(move, reason);
  keep_pieces(move, reason);
}

void Proposer::keep_all(const std::string& reason) {
  for (SmoothedRun& run : plan_.runs) plan_.failed.push_back({run.first_wanted, run.last_wanted, reason});
  plan_.runs.clear();
  rework();
  for (std::size_t i = 0; i < path_.moves.size(); ++i) keep(i, reason);
}

std::size_t Proposer::origin_of(std::size_t i) const { return straight_ ? straight_->origin[i] : i; }

bool Proposer::give_up_tilt(std::size_t move, const std::string& reason) {
  const auto is_of_move = [&](const SmoothedRun& run) {
    // A move whose start is tilted is of the run too.
    return std::ranges::any_of(run.positions, [&](const TiltedPosition& p) {
      return origin_of(p.move) == move || (p.is_end && origin_of(p.move) + 1 == move);
    });
  };
  const auto found = std::ranges::find_if(plan_.runs, is_of_move);
  if (found == plan_.runs.end()) return false;
  plan_.failed.push_back({found->first_wanted, found->last_wanted, reason});
  plan_.runs.erase(found);
  return true;
}

void Proposer::keep_pieces(std::size_t move, const std::string& reason) {
  if (!tilted_ && !straight_) return corrector_->keep(move, reason);
  const std::vector<std::size_t>& origin = (tilted_ ? tilted_ : straight_)->origin;
  for (auto piece = std::lower_bound(origin.begin(), origin.end(), move); piece != origin.end() && *piece == move;
       ++piece)
    corrector_->keep(static_cast<std::size_t>(piece - origin.begin()), reason);
}

void Proposer::add_tilts(Correction& correction) const {
  for (const SmoothedRun& run : plan_.runs) {
    for (const TiltedPosition& p : run.positions) {
      const Move& move = path_.moves[origin_of(p.move)];
      const ToolVariants& tool = *tools_[move.tool];
      const bool is_end = p.is_end && (!straight_ || p.move + 1 == straight_->origin.size() ||
                                       origin_of(p.move + 1) != origin_of(p.move));
      correction.records.push_back({origin_of(p.move), Strategy::tilt, !is_end, p.pose.tip - p.programmed.tip,
                                    result_.verdicts[origin_of(p.move)].depth_mm,
                                    checker_.measure(p.pose, move.kind, tool).depth_mm, 0, p.tilt_rad});
    }
  }
  for (const UntiltedRun& run : plan_.failed) {
    correction.not_tilted.push_back({origin_of(run.first_wanted), origin_of(run.last_wanted), run.reason});
    for (Uncorrected& left : correction.uncorrected) {
      if (left.move >= origin_of(run.first_wanted) && left.move <= origin_of(run.last_wanted))
        left.reason = run.reason + "; " + left.reason;
    }
  }
}

void Proposer::add_holes(Correction& correction) const {
  for (const HolePlan& hole : holes_) {
    const auto is_of_it = [&hole](const auto& thing) { return thing.move >= hole.first && thing.move < hole.last; };
    if (std::any_of(correction.changes.begin(), correction.changes.end(), is_of_it)) continue;
    PathChange change;
    change.move = hole.first;
    change.hole_shift_mm = hole.shift_mm;
    correction.changes.push_back(change);
    correction.records.push_back(
        {hole.first, Strategy::axis, false, hole.shift_mm, hole.depth_before_mm, hole.depth_after_mm, 1});
    std::erase_if(correction.uncorrected, is_of_it);
  }
  sort_by_move(correction.changes);
  sort_by_move(correction.records);
}

}  // namespace gouge

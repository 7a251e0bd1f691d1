#include "lib/correct/proposer.h"

#include <algorithm>
#include <limits>

#include "lib/correct/keep_arcs.h"
#include "lib/correct/tilt_path.h"
#include "lib/path/path_info.h"

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
                   const CorrectOptions& correct, const ProgressCall& progress,
                   std::shared_ptr<const StockAtMoves> stock)
    : path_(path),
      result_(result),
      tools_(setup.tools),
      checker_(MotionChecker(setup).with_stock(std::move(stock))),
      correct_(correct) {
  if (correct.rewritable != nullptr) can_keep_arc_ = correct.rewritable->arc;
  if (correct.rewritable != nullptr) can_split_ = correct.rewritable->split;
  can_split_.resize(path.moves.size(), false);
  plan_tilting(progress);
  rework();
  holes_ = plan_holes(path, result, tools_, checker_, correct);
}

void Proposer::plan_tilting(const ProgressCall& progress) {
  const bool has_axes = correct_.rewritable == nullptr || correct_.rewritable->has_axes || correct_.may_add_axes;
  TiltProposal proposal =
      propose_tilts({path_, result_, tools_, checker_, correct_.strategies, correct_.tilt, has_axes}, progress);
  straight_ = std::move(proposal.straight);
  plan_ = std::move(proposal.plan);
  for (std::size_t i = 0; i < proposal.is_wanted.size() && !has_axes; ++i) {
    if (proposal.is_wanted[i]) plan_.failed.push_back({i, i, kNoAxes});
  }
}

void Proposer::rework() {
  tilted_.reset();
  if (!plan_.runs.empty()) tilted_ = tilt_path(path_, result_, straight_, plan_, tools_, checker_);
  plan_trimming();
  const ReworkedPath* const base = last();
  corrector_ =
      std::make_unique<PathCorrector>(base != nullptr ? base->path : path_, base != nullptr ? base->result : result_,
                                      tools_, checker_, correct_, base != nullptr ? &base->origin : nullptr);
  for (const KeptMove& kept : kept_) keep_pieces(kept.move, kept.reason);
  for (const Untrimmed& failed : trims_.failed) {
    for (std::size_t i = failed.first; i <= failed.last; ++i)
      keep_pieces(untrimmed() != nullptr ? untrimmed()->origin[i] : i, failed.reason);
  }
}

const ReworkedPath* Proposer::untrimmed() const { return tilted_ ? &*tilted_ : straight_ ? &*straight_ : nullptr; }
const ReworkedPath* Proposer::last() const { return trimmed_ ? &*trimmed_ : untrimmed(); }

// Plans the stretches to leave out. Rapids are not left out but lifted over obstacles, whatever the strategy: that
// leaves nothing uncut.
void Proposer::plan_trimming() {
  trimmed_.reset();
  trims_ = TrimPlan();
  const ReworkedPath* const base = untrimmed();
  const Toolpath& path = base != nullptr ? base->path : path_;
  const CheckResult& result = base != nullptr ? base->result : result_;
  std::vector<bool> is_wanted = moves_to(Strategy::trim, path, result, correct_.strategies);
  std::vector<Untrimmed> given_up;
  for (std::size_t i = 0; i < is_wanted.size(); ++i) {
    if (!is_wanted[i]) continue;
    is_wanted[i] = path.moves[i].kind != MoveKind::rapid;
    const std::size_t origin = base != nullptr ? base->origin[i] : i;
    const auto refused = not_trimmed_.find(origin);
    if (refused == not_trimmed_.end()) continue;
    is_wanted[i] = false;
    given_up.push_back({i, i, refused->second});
  }
  if (std::ranges::find(is_wanted, true) != is_wanted.end()) {
    const bool can_write_rapids = correct_.rewritable != nullptr && correct_.rewritable->has_rapids;
    trims_ = plan_trims({path, result, tools_, checker_, is_wanted, correct_.max_shift_mm, correct_.rapid_clearance_mm,
                         can_write_rapids});
  }
  trims_.failed.insert(trims_.failed.end(), given_up.begin(), given_up.end());
  if (trims_.trims.empty()) return;
  std::vector<NewPosition> positions;
  for (const Trim& trim : trims_.trims) positions.insert(positions.end(), trim.positions.begin(), trim.positions.end());
  trimmed_ = with_positions(path_, result_, base, positions, tools_, checker_);
}

Correction Proposer::propose(const ProgressCall& progress) {
  Correction correction = corrector_->propose(progress);
  if (last() != nullptr) {
    correction = restore_moves(*last(), path_, result_, std::move(correction));
    if (!can_keep_arc_.empty()) {
      // A curve that is partly left out cannot stay an arc.
      std::vector<bool> can_keep = can_keep_arc_;
      for (const Trim& trim : trims_.trims) {
        for (const NewPosition& p : trim.positions)
          can_keep[untrimmed() ? untrimmed()->origin[p.move] : p.move] = false;
      }
      keep_arcs({path_, tools_, checker_, correct_, can_keep, can_split_}, correction);
    }
  }
  add_tilts(correction);
  add_trims(correction);
  add_holes(correction);
  // A position is changed because of the gouge of its own move or of a neighbouring move.
  for (ChangeRecord& record : correction.records) {
    if (record.cause == kNone) record.cause = deepest(record.move, record.move);
    const std::size_t before = record.move > 0 ? record.move - 1 : 0;
    if (record.cause == kNone) record.cause = deepest(before, std::min(record.move + 1, path_.moves.size() - 1));
  }
  return correction;
}

// Returns the deepest gouge. A buried move counts as deeper than any depth.
std::size_t Proposer::deepest(std::size_t first, std::size_t last) const {
  std::size_t found = kNone;
  double max_mm = -1;
  for (std::size_t i = first; i <= last; ++i) {
    const MoveVerdict& verdict = result_.verdicts[i];
    const bool is_buried = verdict.state == MoveState::buried;
    if (!is_buried && verdict.state != MoveState::gouge) continue;
    const double depth_mm = is_buried ? std::numeric_limits<double>::infinity() : verdict.depth_mm;
    if (depth_mm > max_mm) {
      found = i;
      max_mm = depth_mm;
    }
  }
  return found;
}

std::vector<KeptMove> Proposer::keep(const std::vector<KeptMove>& moves) {
  std::map<std::size_t, std::string> tilts, trims;  // indices of those given up, with the reason of their first move
  std::vector<KeptMove> dealt;
  for (const KeptMove& kept : moves) {
    const std::vector<std::size_t> in_trims = trims_of(kept.move);
    const std::vector<std::size_t> in_tilts = in_trims.empty() ? tilts_of(kept.move) : std::vector<std::size_t>();
    for (const std::size_t k : in_trims) trims.emplace(k, kept.reason);
    for (const std::size_t k : in_tilts) tilts.emplace(k, kept.reason);
    if (!in_trims.empty() || !in_tilts.empty()) dealt.push_back(kept);
  }
  if (dealt.empty()) {
    for (const KeptMove& kept : moves) keep_as_it_is(kept);
    return moves;
  }
  for (const KeptMove& kept : dealt) give_up_hole(kept.move);
  for (const auto& [k, reason] : trims) give_up_trim(trims_.trims[k], reason);
  for (const auto& [k, reason] : tilts)
    plan_.failed.push_back({plan_.runs[k].first_wanted, plan_.runs[k].last_wanted, reason});
  for (auto given_up = tilts.rbegin(); given_up != tilts.rend(); ++given_up)
    plan_.runs.erase(plan_.runs.begin() + static_cast<std::ptrdiff_t>(given_up->first));
  rework();
  return dealt;
}

void Proposer::keep_as_it_is(const KeptMove& kept) {
  give_up_hole(kept.move);
  kept_.push_back(kept);
  keep_pieces(kept.move, kept.reason);
}

void Proposer::give_up_hole(std::size_t move) {
  std::erase_if(holes_.lifted, [move](const HolePlan& hole) { return move + 1 >= hole.first && move <= hole.last; });
}

void Proposer::give_up_tilts(const std::string& reason) {
  for (const SmoothedRun& run : plan_.runs) plan_.failed.push_back({run.first_wanted, run.last_wanted, reason});
  plan_.runs.clear();
  rework();
}

void Proposer::keep_all(const std::string& reason) {
  for (std::size_t i = 0; i < path_.moves.size(); ++i) not_trimmed_.emplace(i, reason);
  give_up_tilts(reason);
  for (std::size_t i = 0; i < path_.moves.size(); ++i) keep_as_it_is({i, reason});
}

std::size_t Proposer::origin_of(std::size_t i) const { return straight_ ? straight_->origin[i] : i; }

/// Returns the tilted run of a move; more than one if both runs end at it.
std::vector<std::size_t> Proposer::tilts_of(std::size_t move) const {
  std::vector<std::size_t> found;
  for (std::size_t k = 0; k < plan_.runs.size(); ++k) {
    // A move with a tilted start belongs to the run too.
    const bool is_in = std::ranges::any_of(plan_.runs[k].positions, [&](const TiltedPosition& p) {
      return origin_of(p.move) == move || (p.is_end && origin_of(p.move) + 1 == move);
    });
    if (is_in) found.push_back(k);
  }
  return found;
}

std::vector<std::size_t> Proposer::trims_of(std::size_t move) const {
  const ReworkedPath* const base = untrimmed();
  const auto origin = [&](std::size_t i) { return base != nullptr ? base->origin[i] : i; };
  std::vector<std::size_t> found;
  for (std::size_t k = 0; k < trims_.trims.size(); ++k) {
    // A move whose start is above the path belongs to the trim too.
    const Trim& trim = trims_.trims[k];
    if (move >= origin(trim.begin.move) && move <= origin(trim.end.move)) found.push_back(k);
  }
  return found;
}

void Proposer::give_up_trim(const Trim& trim, const std::string& reason) {
  const ReworkedPath* const base = untrimmed();
  const auto origin = [&](std::size_t i) { return base != nullptr ? base->origin[i] : i; };
  for (std::size_t i = origin(trim.begin.move); i <= origin(trim.end.move); ++i) not_trimmed_.emplace(i, reason);
}

void Proposer::keep_pieces(std::size_t move, const std::string& reason) {
  if (last() == nullptr) return corrector_->keep(move, reason);
  const std::vector<std::size_t>& origin = last()->origin;
  for (auto piece = std::lower_bound(origin.begin(), origin.end(), move); piece != origin.end() && *piece == move;
       ++piece)
    corrector_->keep(static_cast<std::size_t>(piece - origin.begin()), reason);
}

void Proposer::add_tilts(Correction& correction) const {
  for (const SmoothedRun& run : plan_.runs) {
    const std::size_t cause = deepest(origin_of(run.first_wanted), origin_of(run.last_wanted));
    for (const TiltedPosition& p : run.positions) {
      const Move& move = path_.moves[origin_of(p.move)];
      const ToolVariants& tool = *tools_[move.tool];
      const bool is_end = p.is_end && (!straight_ || p.move + 1 == straight_->origin.size() ||
                                       origin_of(p.move + 1) != origin_of(p.move));
      correction.records.push_back({origin_of(p.move), Strategy::tilt, !is_end, p.pose.tip - p.programmed.tip,
                                    result_.verdicts[origin_of(p.move)].depth_mm,
                                    checker_.measure(p.pose, move.kind, tool).depth_mm, 0, p.tilt_rad, p.pose, cause});
    }
  }
  for (const UntiltedRun& run : plan_.failed) {
    correction.not_tilted.push_back({origin_of(run.first_wanted), origin_of(run.last_wanted), run.reason});
    for (Uncorrected& left : correction.uncorrected) {
      const bool is_of_run = left.move >= origin_of(run.first_wanted) && left.move <= origin_of(run.last_wanted);
      // A reason for both is stated once.
      if (is_of_run && left.reason.find(run.reason) == std::string::npos) left.reason = run.reason + "; " + left.reason;
    }
  }
}

void Proposer::add_trims(Correction& correction) const {
  const ReworkedPath* const base = untrimmed();
  const auto origin = [&](std::size_t i) { return base != nullptr ? base->origin[i] : i; };
  for (const Trim& trim : trims_.trims) {
    const std::size_t first = origin(trim.begin.move), last = origin(trim.end.move);
    const std::size_t cause = deepest(first, last);
    correction.uncut.push_back(
        {.first_move = first, .last_move = last, .positions = trim.uncut_positions, .length_mm = trim.uncut_mm});
    for (std::size_t k = 0; k < trim.positions.size(); ++k) {
      const NewPosition& p = trim.positions[k];
      const std::size_t move = origin(p.move);
      const bool is_end =
          p.is_end && (base == nullptr || p.move + 1 == base->origin.size() || origin(p.move + 1) != move);
      const Pose& was = trim.programmed[k];
      correction.records.push_back({move, Strategy::trim, !is_end, p.pose.tip - was.tip,
                                    result_.verdicts[move].depth_mm,
                                    checker_.measure(p.pose, p.kind, *tools_[path_.moves[move].tool]).depth_mm, 0,
                                    angle_between_rad(p.pose.axis, was.axis), p.pose, cause});
    }
  }
  for (const Untrimmed& failed : trims_.failed) {
    for (Uncorrected& left : correction.uncorrected) {
      if (left.move >= origin(failed.first) && left.move <= origin(failed.last)) left.reason = failed.reason;
    }
  }
}

void Proposer::add_holes(Correction& correction) const {
  for (const HolePlan& hole : holes_.lifted) {
    const auto is_of_it = [&hole](const auto& thing) { return thing.move >= hole.first && thing.move < hole.last; };
    if (std::any_of(correction.changes.begin(), correction.changes.end(), is_of_it)) continue;
    PathChange change;
    change.move = hole.first;
    change.hole_shift_mm = hole.shift_mm;
    correction.changes.push_back(change);
    correction.records.push_back({hole.first,
                                  Strategy::axis,
                                  false,
                                  hole.shift_mm,
                                  hole.depth_before_mm,
                                  hole.depth_after_mm,
                                  1,
                                  0,
                                  {path_.moves[hole.first].end.tip + hole.shift_mm, path_.moves[hole.first].end.axis},
                                  deepest(hole.first, hole.last - 1)});
    std::erase_if(correction.uncorrected, is_of_it);
    Uncut uncut;
    uncut.first_move = hole.first;
    uncut.last_move = hole.last - 1;
    uncut.length_mm = hole.shift_mm.norm();
    uncut.kind = Uncut::Kind::hole;
    correction.uncut.push_back(uncut);
  }
  std::ranges::stable_sort(correction.uncut, {}, &Uncut::first_move);
  for (const HoleLeft& hole : holes_.left) {
    for (Uncorrected& left : correction.uncorrected) {
      if (left.move >= hole.first && left.move < hole.last) left.reason = hole.reason;
    }
  }
  sort_by_move(correction.changes);
  sort_by_move(correction.records);
}

}  // namespace gouge

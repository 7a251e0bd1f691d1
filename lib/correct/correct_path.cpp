#include "lib/correct/correct_path.h"

#include <algorithm>
#include <memory>

#include "lib/correct/keep_arcs.h"
#include "lib/correct/laws.h"
#include "lib/correct/path_corrector.h"
#include "lib/correct/plan_holes.h"
#include "lib/correct/straighten.h"

namespace gouge {
namespace {

constexpr int kRounds = 6;  // in which what is worse is taken back, before everything is
constexpr const char* kLeftForLaws = "a change here would make a move of the written file worse";
constexpr const char* kUnwritable = "the file's records do not allow this change: ";

/// Proposes for a path whose curves become straight moves where they must.
class Proposer {
 public:
  Proposer(const Toolpath& path, const CheckResult& result, const CheckSetup& setup, const CorrectOptions& correct)
      : path_(path), result_(result), tools_(setup.tools), checker_(setup), correct_(correct) {
    if (correct.rewritable != nullptr) can_keep_arc_ = correct.rewritable->arc;
    if (correct.rewritable != nullptr) can_split_ = correct.rewritable->split;
    can_split_.resize(path.moves.size(), false);
    straight_ = straighten(path, result, tools_, checker_);
    corrector_ = std::make_unique<PathCorrector>(straight_ ? straight_->path : path,
                                                 straight_ ? straight_->result : result, tools_, checker_, correct);
    holes_ = plan_holes(path, result, tools_, checker_, correct);
  }

  Correction propose(const ProgressCall& progress) {
    Correction correction = corrector_->propose(progress);
    if (straight_) {
      correction = restore_curves(*straight_, path_, result_, std::move(correction));
      if (!can_keep_arc_.empty()) keep_arcs({path_, tools_, checker_, correct_, can_keep_arc_, can_split_}, correction);
    }
    add_holes(correction);
    return correction;
  }

  /// What was proposed as an arc becomes straight from now on. False where it was not.
  [[nodiscard]] bool give_up_arc(const std::vector<PathChange>& changes, std::size_t move) {
    const bool was_arc = std::any_of(changes.begin(), changes.end(),
                                     [move](const PathChange& c) { return c.move == move && c.has_arc(); });
    if (was_arc) can_keep_arc_[move] = false;
    return was_arc;
  }

  void keep(std::size_t move, const std::string& reason) {
    std::erase_if(holes_, [move](const HolePlan& hole) { return move + 1 >= hole.first && move <= hole.last; });
    if (!straight_) return corrector_->keep(move, reason);
    const std::vector<std::size_t>& origin = straight_->origin;
    for (auto piece = std::lower_bound(origin.begin(), origin.end(), move); piece != origin.end() && *piece == move;
         ++piece)
      corrector_->keep(static_cast<std::size_t>(piece - origin.begin()), reason);
  }

  void keep_all(const std::string& reason) {
    for (std::size_t i = 0; i < path_.moves.size(); ++i) keep(i, reason);
  }

 private:
  void add_holes(Correction& correction) const {
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
    const auto by_move = [](const auto& a, const auto& b) { return a.move < b.move; };
    std::stable_sort(correction.changes.begin(), correction.changes.end(), by_move);
    std::stable_sort(correction.records.begin(), correction.records.end(), by_move);
  }

  const Toolpath& path_;
  const CheckResult& result_;
  const std::vector<const ToolVariants*>& tools_;
  MotionChecker checker_;
  const CorrectOptions& correct_;
  std::vector<HolePlan> holes_;
  std::vector<bool> can_keep_arc_, can_split_;
  std::optional<StraightenedPath> straight_;
  std::unique_ptr<PathCorrector> corrector_;
};

/// Where nothing says which change cannot be written: those of the line named.
std::vector<std::size_t> moves_of_line(const Toolpath& path, const std::vector<PathChange>& changes, std::size_t line) {
  std::vector<std::size_t> moves;
  for (const PathChange& change : changes) {
    const std::size_t next = std::min(change.move + 1, path.moves.size() - 1);
    if (path.moves[change.move].line == line || path.moves[next].line == line) moves.push_back(change.move);
  }
  return moves;
}

bool is_bad(const MoveVerdict& verdict) {
  return verdict.state == MoveState::gouge || verdict.state == MoveState::buried;
}

/// Every move that is bad at the end, with the reason known or the usual one.
std::vector<Uncorrected> list_remaining(const Toolpath& path, const CheckResult& before, const Correction& correction,
                                        const CheckResult& after) {
  std::vector<const Uncorrected*> known(path.moves.size(), nullptr);
  for (const Uncorrected& left : correction.uncorrected) known[left.move] = &left;
  std::vector<bool> is_changed(path.moves.size(), false);
  for (const PathChange& change : correction.changes) {
    const std::size_t last = change.hole_shift_mm ? end_of_hole(path, change.move) : change.move + 1;
    std::fill(is_changed.begin() + static_cast<std::ptrdiff_t>(change.move),
              is_changed.begin() + static_cast<std::ptrdiff_t>(last), true);
  }
  const std::vector<MovesAfter> spans = moves_after(path.moves.size(), correction.changes);
  std::vector<Uncorrected> remaining;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const MoveVerdict* worst = nullptr;
    for (std::size_t k = spans[i].first; k < spans[i].last; ++k) {
      const MoveVerdict& verdict = after.verdicts[k];
      if (is_bad(verdict) && (worst == nullptr || verdict.depth_mm > worst->depth_mm)) worst = &verdict;
    }
    if (worst == nullptr) continue;
    const double depth = is_changed[i] ? worst->depth_mm : before.verdicts[i].depth_mm;
    const std::string reason = known[i] != nullptr ? known[i]->reason : usual_reason(path.moves[i], *worst);
    remaining.push_back({i, worst->state == MoveState::gouge ? depth : 0, reason, is_changed[i]});
  }
  return remaining;
}

}  // namespace

Correction correct_path(const Toolpath& toolpath, const CheckResult& result, const CheckSetup& setup,
                        const CorrectOptions& correct, const ProgressCall& progress) {
  return Proposer(toolpath, result, setup, correct).propose(progress);
}

Result<LawfulCorrection> correct_lawfully(const Toolpath& toolpath, const CheckResult& result, const CheckSetup& setup,
                                          const CorrectOptions& correct, const RewritePath& rewrite,
                                          const ProgressCall& progress) {
  Proposer proposer(toolpath, result, setup, correct);
  for (int round = 0;; ++round) {
    Correction correction = proposer.propose(progress);
    Result<Toolpath> changed = rewrite(correction.changes);
    if (!changed && correction.changes.empty()) return changed.error();
    std::vector<std::size_t> worse;
    std::string reason = kLeftForLaws;
    if (changed) {
      ChangedPath after{std::move(*changed), {}};
      after.result = check(after.path, setup, progress);
      worse = find_worse({&toolpath, &result}, correction.changes, {&after.path, &after.result},
                         setup.options.resolution_mm);
      if (worse.empty()) {
        correction.uncorrected = list_remaining(toolpath, result, correction, after.result);
        return LawfulCorrection{std::move(correction), std::move(after)};
      }
      if (correction.changes.empty()) {
        return make_error("correct-law",
                          "the file as it was written without a change reads or checks otherwise; nothing was written",
                          toolpath.file, toolpath.moves[worse.front()].line);
      }
    } else {
      worse = moves_of_line(toolpath, correction.changes, changed.error().line);
      reason = kUnwritable + changed.error().message;
    }
    // One that a change does not touch follows from others, which only taking all of them back is sure to end.
    const bool is_touched = std::any_of(worse.begin(), worse.end(), [&](std::size_t i) {
      return std::any_of(correction.changes.begin(), correction.changes.end(),
                         [&](const PathChange& c) { return c.move == i || c.move + 1 == i; });
    });
    if (round >= kRounds || !is_touched) {
      proposer.keep_all(reason);
    } else {
      for (const std::size_t i : worse) {
        if (!proposer.give_up_arc(correction.changes, i)) proposer.keep(i, reason);
      }
    }
  }
}

}  // namespace gouge

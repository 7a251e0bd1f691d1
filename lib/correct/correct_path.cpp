#include "lib/correct/correct_path.h"

#include <algorithm>

#include "lib/correct/laws.h"
#include "lib/correct/lifted_cuts.h"
#include "lib/correct/low_rapids.h"
#include "lib/correct/measure_stock.h"
#include "lib/correct/plan_holes.h"
#include "lib/correct/proposer.h"

namespace gouge {
namespace {

constexpr int kRounds = 6;  // in which what is worse is taken back, before everything is
constexpr const char* kLeftForLaws = "a change here would make a move of the written file worse";
constexpr const char* kUnwritable = "the file's records do not allow this change: ";

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

// Part and path lie to each other as before: a path that was lifted from the part does not show otherwise, and one that
// did not fit does not fit now.
void keep_place(const CheckResult& before, CheckResult& after) {
  for (const Subject fact : {Subject::mesh_unit, Subject::placement})
    copy_facts(fact, before.assumptions, after.assumptions);
}

void add_lifted_cuts(const Toolpath& path, const Toolpath& after, const CheckSetup& setup, Correction& correction) {
  const std::vector<Uncut> lifted = find_lifted_cuts(path, correction, after, setup);
  correction.uncut.insert(correction.uncut.end(), lifted.begin(), lifted.end());
  std::ranges::stable_sort(correction.uncut, {}, &Uncut::first);
}

}  // namespace

Correction correct_path(const Toolpath& toolpath, const CheckResult& result, const CheckSetup& setup,
                        const CorrectOptions& correct, const ProgressCall& progress) {
  return Proposer(toolpath, result, setup, correct, progress).propose(progress);
}

Result<LawfulCorrection> correct_lawfully(const Toolpath& toolpath, const CheckResult& result, const CheckSetup& setup,
                                          const CorrectOptions& correct, const RewritePath& rewrite,
                                          const ProgressCall& progress) {
  Proposer proposer(toolpath, result, setup, correct, progress);
  for (int round = 0;; ++round) {
    Correction correction = proposer.propose(progress);
    Result<Toolpath> changed = rewrite(correction.changes);
    if (!changed && correction.changes.empty()) return changed.error();
    std::vector<std::size_t> worse;
    std::string reason = kLeftForLaws;
    if (changed) {
      ChangedPath after{std::move(*changed), {}};
      after.result = check_moves(after.path, setup, progress);
      worse = find_worse({&toolpath, &result}, correction.changes, {&after.path, &after.result}, setup.options);
      if (worse.empty()) {
        correction.uncorrected = list_remaining(toolpath, result, correction, after.result);
        if (progress) progress("measuring what is left", 0, 1);
        correction.stock = measure_stock(toolpath, correction, after.path, setup, correct);
        assess(after.path, setup, after.result);
        keep_place(result, after.result);
        add_lifted_cuts(toolpath, after.path, setup, correction);
        correction.low_rapids = find_low_rapids(toolpath, correction, after.path, setup, correct);
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

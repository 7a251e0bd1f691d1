#include "postproc/compare/match_findings.h"

#include <algorithm>
#include <limits>
#include <set>

#include "lib/path/toolpath.h"
#include "postproc/compare/witness_grid.h"

namespace gouge {
namespace {

bool is_alike(const StoredFinding& a, const StoredFinding& b) {
  return a.tool == b.tool && a.body == b.body && a.against == b.against;
}

// Findings of one run whose motions are none of the other's.
std::vector<std::size_t> without_motion(const StoredResult& result, const std::vector<std::size_t>& other_move) {
  std::vector<std::size_t> all;
  for (std::size_t k = 0; k < result.findings.size(); ++k) {
    const auto moves = result.moves_of(result.findings[k]);
    if (std::ranges::none_of(moves, [&](const StoredMove* move) { return other_move[move->move] != kNone; }))
      all.push_back(k);
  }
  return all;
}

class Matcher {
 public:
  Matcher(const StoredResult& before, const StoredResult& after, const MotionAlignment& motions)
      : before_(before), after_(after), motions_(motions), matched_(after.findings.size()) {}

  std::vector<std::vector<std::size_t>> run() {
    by_motions();
    const std::vector<std::size_t> lost = without_motion(before_, motions_.before_to_after);
    const std::vector<std::size_t> changed = without_motion(after_, motions_.after_to_before);
    by_statement(WitnessGrid(before_, lost, kSameStatement_mm), changed);
    by_place(WitnessGrid(before_, lost, kSamePlace_mm), changed);
    return std::move(matched_);
  }

 private:
  void by_motions() {
    std::vector<std::vector<std::size_t>> finding_of(before_.motions.size());
    for (std::size_t k = 0; k < before_.findings.size(); ++k) {
      for (const StoredMove* move : before_.moves_of(before_.findings[k])) finding_of[move->move].push_back(k);
    }
    for (std::size_t n = 0; n < after_.findings.size(); ++n) {
      std::set<std::size_t> found;
      for (const StoredMove* move : after_.moves_of(after_.findings[n])) {
        const std::size_t other = motions_.after_to_before[move->move];
        if (other == kNone) continue;
        for (const std::size_t k : finding_of[other]) {
          if (is_alike(before_.findings[k], after_.findings[n])) found.insert(k);
        }
      }
      matched_[n].assign(found.begin(), found.end());
    }
  }

  // To the nearest of the finding's statements.
  void by_statement(const WitnessGrid& before, const std::vector<std::size_t>& changed) {
    std::set<std::size_t> taken;
    for (const std::size_t n : changed) {
      const StoredMove& worst = after_.worst_of(after_.findings[n]);
      if (!worst.witness || worst.statement.empty()) continue;
      double least_mm = std::numeric_limits<double>::infinity();
      std::size_t nearest = kNone;
      before.for_each_near(worst.witness->point, [&](const WitnessGrid::Near& near, double apart_mm) {
        if (near.move->statement != worst.statement || apart_mm >= least_mm) return;
        if (taken.contains(near.finding) || !is_alike(before_.findings[near.finding], after_.findings[n])) return;
        least_mm = apart_mm;
        nearest = near.finding;
      });
      if (nearest == kNone) continue;
      matched_[n] = {nearest};
      taken.insert(nearest);
    }
    taken_ = std::move(taken);
  }

  // To all that are there: a path that was made anew splits findings and joins them.
  void by_place(const WitnessGrid& before, const std::vector<std::size_t>& changed) {
    for (const std::size_t n : changed) {
      if (!matched_[n].empty()) continue;
      std::set<std::size_t> found;
      for (const StoredMove* move : after_.moves_of(after_.findings[n])) {
        if (!move->witness) continue;
        before.for_each_near(move->witness->point, [&](const WitnessGrid::Near& near, double) {
          if (!taken_.contains(near.finding) && is_alike(before_.findings[near.finding], after_.findings[n]))
            found.insert(near.finding);
        });
      }
      matched_[n].assign(found.begin(), found.end());
    }
  }

  const StoredResult& before_;
  const StoredResult& after_;
  const MotionAlignment& motions_;
  std::vector<std::vector<std::size_t>> matched_;
  std::set<std::size_t> taken_;
};

}  // namespace

std::vector<std::vector<std::size_t>> match_findings(const StoredResult& before, const StoredResult& after,
                                                     const MotionAlignment& motions) {
  return Matcher(before, after, motions).run();
}

}  // namespace gouge

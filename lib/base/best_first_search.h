#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace gouge {

/// A gap that leaves a value open: that it is above the tolerance is all that is wanted.
inline constexpr double kAnyGap_mm = 1e6;

/// Conditions on which a search for a largest value stops.
struct SearchGoal {
  double tolerance_mm = 0;   ///< enough is a proof that the value is at most this ...
  double resolution_mm = 0;  ///< ... plus this;
  double gap_mm = 0;         ///< above the tolerance the value itself is wanted, to this gap (kAnyGap_mm: it is not)
  std::uint64_t budget = 0;  ///< bounds to compute before giving up

  /// Candidates whose upper bound is no larger need no further look once `value_mm` was measured.
  [[nodiscard]] double pruning_threshold_mm(double value_mm) const {
    return value_mm > tolerance_mm ? value_mm + gap_mm : tolerance_mm + resolution_mm;
  }
  /// Returns whether nothing more is wanted once `value_mm` was measured.
  [[nodiscard]] bool is_met_by(double value_mm) const { return gap_mm >= kAnyGap_mm && value_mm > tolerance_mm; }
};

/// Base of the candidates of all searches.
struct SearchCandidate {
  double upper_mm = 0;       ///< nowhere in it is the value larger
  std::uint32_t serial = 0;  ///< of equal bounds the one offered first is taken first
};

/// Certified best-first branch and bound for a largest value, the one loop of all such searches.
///
/// `Problem` derives from it. It offers the first candidates, which must cover the domain, before it calls `run`. It
/// has these public members.
///   double threshold_mm() const            By the largest value measured so far.
///   bool is_exhausted() const              True once the budget has run out.
///   void split(const Candidate&)           Bounds the parts of a candidate, measures the value at points of them,
///                                          and offers them.
///   static constexpr bool kDescends        True to go from a candidate straight down to where its best part is
///                                          decided. A value close to the bound is then measured early, even where
///                                          many candidates have the same bound.
///
/// Ensures  The same order on every machine. Every candidate was split or its bound is in what `run` returns.
/// Source   A. H. Land, A. G. Doig, An automatic method of solving discrete programming problems (1960).
template <typename Problem, typename Candidate>
class BestFirstSearch {
 protected:
  /// A candidate not above the threshold is given up at once.
  void offer(const Candidate& candidate) {
    if (is_pruned(candidate)) return;
    offered_.push_back(candidate);
    offered_.back().serial = serial_++;
  }

  /// The largest bound of all candidates that were not split: with the largest value measured the upper bound of the
  /// value, at any budget.
  double run() {
    for (const Candidate& candidate : offered_) keep(candidate);
    while (!open_.empty() && open_.front().upper_mm > threshold_mm()) {
      is_decided_ = !problem().is_exhausted();
      if (!is_decided_) break;
      std::pop_heap(open_.begin(), open_.end(), comes_later);
      Candidate next = open_.back();
      open_.pop_back();
      expand(next);
    }
    return open_.empty() ? pruned_mm_ : std::max(pruned_mm_, open_.front().upper_mm);
  }

  /// Returns after `run` the candidate with the largest bound of those above the threshold that were not split; null:
  /// none.
  [[nodiscard]] const Candidate* undecided() const {
    return open_.empty() || !(open_.front().upper_mm > threshold_mm()) ? nullptr : &open_.front();
  }

  /// Returns false where the budget ran out first.
  [[nodiscard]] bool is_decided() const { return is_decided_; }

  /// Counts bounds that were proved before as those of pruned candidates.
  void prune(double upper_mm) { pruned_mm_ = std::max(pruned_mm_, upper_mm); }

 private:
  static bool comes_later(const Candidate& a, const Candidate& b) {
    return a.upper_mm < b.upper_mm || (!(b.upper_mm < a.upper_mm) && a.serial > b.serial);
  }

  void expand(Candidate next) {
    for (;;) {
      offered_.clear();
      problem().split(next);
      const auto best =
          Problem::kDescends ? std::max_element(offered_.begin(), offered_.end(), comes_later) : offered_.end();
      for (auto it = offered_.begin(); it != offered_.end(); ++it) {
        if (it != best) keep(*it);
      }
      if (best == offered_.end()) return;
      if (best->upper_mm <= threshold_mm() || problem().is_exhausted()) return keep(*best);
      next = *best;
    }
  }

  // The threshold may have risen since the candidate was offered.
  void keep(const Candidate& candidate) {
    if (is_pruned(candidate)) return;
    open_.push_back(candidate);
    std::push_heap(open_.begin(), open_.end(), comes_later);
  }

  bool is_pruned(const Candidate& candidate) {
    const bool is_low = candidate.upper_mm <= threshold_mm();
    if (is_low) prune(candidate.upper_mm);
    return is_low;
  }

  [[nodiscard]] double threshold_mm() const { return static_cast<const Problem*>(this)->threshold_mm(); }
  Problem& problem() { return *static_cast<Problem*>(this); }

  std::vector<Candidate> open_;     // a heap
  std::vector<Candidate> offered_;  // not yet kept
  std::uint32_t serial_ = 0;
  double pruned_mm_ = 0;
  bool is_decided_ = true;
};

}  // namespace gouge

#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace gouge {

/// A gap that leaves the value open: the search ends as soon as the value is proved to be above the tolerance.
inline constexpr double kAnyGap_mm = 1e6;

/// Conditions on which a search for a largest value stops.
struct SearchGoal {
  double tolerance_mm = 0;   ///< a proof that the value is at most this ...
  double resolution_mm = 0;  ///< ... plus this ends the search
  double gap_mm = 0;         ///< accuracy of a value above the tolerance (kAnyGap_mm: the value is not needed)
  std::uint64_t budget = 0;  ///< number of bounds that may be computed

  /// Returns the upper bound up to which a candidate can be ignored, once `value_mm` was measured.
  [[nodiscard]] double pruning_threshold_mm(double value_mm) const {
    return value_mm > tolerance_mm ? value_mm + gap_mm : tolerance_mm + resolution_mm;
  }
  /// Returns whether a measured `value_mm` ends the search.
  [[nodiscard]] bool is_met_by(double value_mm) const { return gap_mm >= kAnyGap_mm && value_mm > tolerance_mm; }
};

/// Base of the candidates of all searches.
struct SearchCandidate {
  double upper_mm = 0;       ///< upper bound of the value in the candidate
  std::uint32_t serial = 0;  ///< order of the offers; among equal bounds the lower number is split first
};

/// Certified best-first branch and bound for a largest value. All such searches share this loop.
///
/// `Problem` derives from it. It offers the first candidates, which must cover the domain, before it calls `run`. It
/// has these public members.
///   double threshold_mm() const            Returns the threshold that follows from the largest measured value.
///   bool is_exhausted() const              Returns true once the budget is spent.
///   void split(const Candidate&)           Bounds the parts of a candidate, measures the value at points of them,
///                                          and offers them.
///   static constexpr bool kDescends        True: after a candidate its best part is split next, down to a part that
///                                          is decided. A value close to the bound is then measured early, even if
///                                          many candidates have the same bound.
///
/// Ensures  The order is the same on every machine. Each candidate is split, or its bound enters the result of `run`.
/// Source   A. H. Land, A. G. Doig, An automatic method of solving discrete programming problems (1960).
template <typename Problem, typename Candidate>
class BestFirstSearch {
 protected:
  /// Keeps a candidate for later. A candidate whose bound is not above the threshold is discarded at once.
  void offer(const Candidate& candidate) {
    if (is_pruned(candidate)) return;
    offered_.push_back(candidate);
    offered_.back().serial = serial_++;
  }

  /// Runs the search. Returns the largest bound of all candidates that were not split. The larger of it and the largest
  /// measured value is an upper bound of the value, at any budget.
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

  /// Returns, after `run`, the candidate with the largest bound among those that are above the threshold and were not
  /// split. Returns null if there is none.
  [[nodiscard]] const Candidate* undecided() const {
    return open_.empty() || !(open_.front().upper_mm > threshold_mm()) ? nullptr : &open_.front();
  }

  /// Returns false if the budget ran out first.
  [[nodiscard]] bool is_decided() const { return is_decided_; }

  /// Treats `upper_mm`, a bound that was proved before, as the bound of a pruned candidate.
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

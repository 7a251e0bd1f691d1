#include "postproc/compare/match_findings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "lib/path/toolpath.h"
#include "postproc/compare/contact_depth.h"

namespace gouge {

bool is_alike(const EventRecord& a, const EventRecord& b) {
  return a.tool == b.tool && a.body == b.body && a.against == b.against;
}

namespace {

// Returns the findings of one run whose motions do not occur in the other run.
std::vector<std::size_t> without_motion(const StoredResult& result, const std::vector<std::size_t>& other_move) {
  std::vector<std::size_t> all;
  for (std::size_t k = 0; k < result.findings.size(); ++k) {
    const auto moves = result.moves_of(result.findings[k]);
    if (std::ranges::none_of(moves, [&](const MoveRecord* move) { return other_move[move->move] != kNone; }))
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
    std::vector<std::vector<std::size_t>> finding_of(before_.record.listed_motions());
    for (std::size_t k = 0; k < before_.findings.size(); ++k) {
      for (const MoveRecord* move : before_.moves_of(before_.findings[k])) finding_of[move->move].push_back(k);
    }
    for (std::size_t n = 0; n < after_.findings.size(); ++n) {
      std::set<std::size_t> found;
      for (const MoveRecord* move : after_.moves_of(after_.findings[n])) {
        const std::size_t other = motions_.after_to_before[move->move];
        if (other == kNone) continue;
        for (const std::size_t k : finding_of[other]) {
          if (states(before_.findings[k], other, after_.findings[n])) found.insert(k);
        }
      }
      matched_[n].assign(found.begin(), found.end());
    }
  }

  /// Returns whether a move of an earlier finding states the contact of a new finding, if only as a further one.
  [[nodiscard]] bool states(const EventRecord& earlier, std::size_t move, const EventRecord& finding) const {
    return is_alike(earlier, finding) || (earlier.tool == finding.tool && earlier.state == MoveState::gouge &&
                                          contact_depth(*before_.find_move(move), finding.body, finding.against));
  }

  // Matches a finding with the nearest old one that has the same statement.
  void by_statement(const WitnessGrid& before, const std::vector<std::size_t>& changed) {
    std::set<std::size_t> taken;
    for (const std::size_t n : changed) {
      const MoveRecord& worst = after_.worst_of(after_.findings[n]);
      if (!worst.witness || worst.statement.empty()) continue;
      double min_mm = std::numeric_limits<double>::infinity();
      std::size_t nearest = kNone;
      before.for_each_near(worst.witness->point_mm, [&](const WitnessGrid::Near& near, double apart_mm) {
        if (near.move->statement != worst.statement || apart_mm >= min_mm) return;
        if (taken.contains(near.finding) || !is_alike(before_.findings[near.finding], after_.findings[n])) return;
        min_mm = apart_mm;
        nearest = near.finding;
      });
      if (nearest == kNone) continue;
      matched_[n] = {nearest};
      taken.insert(nearest);
    }
    taken_ = std::move(taken);
  }

  // Matches a finding with all old ones at its place, because a path that was computed anew splits and joins findings.
  void by_place(const WitnessGrid& before, const std::vector<std::size_t>& changed) {
    for (const std::size_t n : changed) {
      if (!matched_[n].empty()) continue;
      std::set<std::size_t> found;
      for (const MoveRecord* move : after_.moves_of(after_.findings[n])) {
        if (!move->witness) continue;
        before.for_each_near(move->witness->point_mm, [&](const WitnessGrid::Near& near, double) {
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

WitnessGrid::WitnessGrid(const StoredResult& result, const std::vector<std::size_t>& findings, double reach_mm)
    : reach_mm_(reach_mm) {
  for (const std::size_t k : findings) {
    for (const MoveRecord* move : result.moves_of(result.findings[k])) {
      if (move->witness) cells_[cell_of(move->witness->point_mm)].push_back({k, move});
    }
  }
}

WitnessGrid::Cell WitnessGrid::cell_of(const Vec3& point) const {
  constexpr double kFarthest = 1e15;  // within the range of an integer
  Cell cell{};
  for (std::size_t k = 0; k < cell.size(); ++k) {
    const double at = std::floor(point[static_cast<Eigen::Index>(k)] / reach_mm_);
    cell.at(k) = static_cast<std::int64_t>(std::clamp(at, -kFarthest, kFarthest));
  }
  return cell;
}

namespace {

struct Sides {
  std::size_t before = kNone, after = kNone;
  std::size_t times_before = 0, times_after = 0;
};

using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;

// Returns the motions that occur exactly once in both lists, in the order of `before`.
Pairs unique_pairs(const std::vector<std::string_view>& before, const std::vector<std::string_view>& after) {
  std::unordered_map<std::string_view, Sides> all;
  for (std::size_t i = 0; i < before.size(); ++i) {
    Sides& sides = all[before[i]];
    sides.before = i;
    ++sides.times_before;
  }
  for (std::size_t i = 0; i < after.size(); ++i) {
    const auto found = all.find(after[i]);
    if (found == all.end()) continue;
    found->second.after = i;
    ++found->second.times_after;
  }
  Pairs pairs;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const Sides& sides = all.at(before[i]);
    if (sides.times_before == 1 && sides.times_after == 1) pairs.emplace_back(i, sides.after);
  }
  return pairs;
}

// Returns the longest subsequence whose second numbers increase (Schensted 1961).
Pairs increasing(const Pairs& pairs) {
  // ends[k]: last element of a subsequence of length k + 1
  std::vector<std::size_t> ends, previous(pairs.size(), kNone);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto at = std::ranges::lower_bound(ends, pairs[i].second, {}, [&](std::size_t k) { return pairs[k].second; });
    if (at != ends.begin()) previous[i] = *(at - 1);
    if (at == ends.end()) {
      ends.push_back(i);
    } else {
      *at = i;
    }
  }
  Pairs chosen;
  for (std::size_t i = ends.empty() ? kNone : ends.back(); i != kNone; i = previous[i]) chosen.push_back(pairs[i]);
  std::ranges::reverse(chosen);
  return chosen;
}

}  // namespace

MotionAlignment align_motions(const std::vector<std::string_view>& before, const std::vector<std::string_view>& after) {
  MotionAlignment made{std::vector<std::size_t>(before.size(), kNone), std::vector<std::size_t>(after.size(), kNone)};
  const auto join = [&](std::size_t i, std::size_t j) {
    made.before_to_after[i] = j;
    made.after_to_before[j] = i;
  };
  const auto is_free = [&](std::size_t i, std::size_t j) {
    return made.before_to_after[i] == kNone && made.after_to_before[j] == kNone && before[i] == after[j];
  };
  std::size_t first = 0;
  const std::size_t shorter = std::min(before.size(), after.size());
  for (; first < shorter && is_free(first, first); ++first) join(first, first);
  for (std::size_t k = 1; first + k <= shorter && is_free(before.size() - k, after.size() - k); ++k)
    join(before.size() - k, after.size() - k);
  Pairs unique = unique_pairs(before, after);
  std::erase_if(unique, [&](const auto& pair) { return !is_free(pair.first, pair.second); });
  const Pairs anchors = increasing(unique);
  for (const auto& [i, j] : anchors) join(i, j);
  for (auto [i, j] : anchors) {
    while (++i < before.size() && ++j < after.size() && is_free(i, j)) join(i, j);
  }
  for (auto [i, j] : anchors) {
    while (i-- > 0 && j-- > 0 && is_free(i, j)) join(i, j);
  }
  return made;
}

}  // namespace gouge

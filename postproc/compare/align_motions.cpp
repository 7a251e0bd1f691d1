#include "postproc/compare/align_motions.h"

#include <algorithm>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "lib/path/toolpath.h"

namespace gouge {
namespace {

struct Sides {
  std::size_t before = kNone, after = kNone;
  std::size_t times_before = 0, times_after = 0;
};

using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;

// In the order of `before`.
Pairs unique_pairs(const std::vector<std::string>& before, const std::vector<std::string>& after) {
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

// The longest subsequence whose second numbers increase (Schensted 1961).
Pairs increasing(const Pairs& pairs) {
  std::vector<std::size_t> ends, previous(pairs.size(), kNone);  // ends[k]: of a subsequence of length k + 1
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

MotionAlignment align_motions(const std::vector<std::string>& before, const std::vector<std::string>& after) {
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

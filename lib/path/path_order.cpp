#include "lib/path/path_order.h"

#include <algorithm>
#include <vector>

#include "lib/path/motion_chords.h"
#include "lib/path/tip_grid.h"

namespace gouge {
namespace {

constexpr std::size_t kMaxTried = 1000;  // positions that feeds are searched for others that pass them

/// A position that each path reaches once: its move in each.
struct Common {
  std::size_t move, other;
};

TipGrid ends_of(const Toolpath& path, double within_mm) {
  TipGrid ends(within_mm);
  for (std::size_t i = 0; i < path.moves.size(); ++i)
    if (is_checked_feed(path.moves[i])) ends.add(path.moves[i].end.tip, i);
  return ends;
}

/// Returns the common positions in the order of `path`.
std::vector<Common> find_common(const Toolpath& path, const Toolpath& other, double within_mm) {
  const TipGrid ends = ends_of(path, within_mm), other_ends = ends_of(other, within_mm);
  std::vector<Common> common;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    if (!is_checked_feed(path.moves[i]) || ends.find(path.moves[i].end.tip, 2).size() != 1) continue;
    const std::vector<std::size_t> found = other_ends.find(path.moves[i].end.tip, 2);
    if (found.size() != 1) continue;
    const Vec3& tip = other.moves[found[0]].end.tip;
    if (other_ends.find(tip, 2).size() == 1 && ends.find(tip, 2).size() == 1) common.push_back({i, found[0]});
  }
  return common;
}

/// Returns whether no feed passes the end of a move, except that move and the next feed, which begins there.
bool is_passed_once(const std::vector<MotionChord>& feeds, const Toolpath& path, std::size_t move, double within_mm) {
  const Pose& end = path.moves[move].end;
  return std::ranges::none_of(feeds, [&](const MotionChord& feed) {
    const bool is_own = feed.move == move || (feed.move == move + 1 && path.moves[feed.move].has_start);
    return !is_own && tip_bound_mm(end, feed) <= within_mm && distance_from(end, feed).tip_mm <= within_mm;
  });
}

}  // namespace

PathOrder compare_order(const Toolpath& path, const Toolpath& other, double within_mm) {
  const std::vector<Common> by_path = find_common(path, other, within_mm);
  PathOrder order{by_path.size()};
  std::vector<Common> by_other = by_path;
  std::ranges::sort(by_other, {}, &Common::other);
  std::vector<MotionChord> feeds, other_feeds;
  const auto is_certain = [&](const Common& common) {
    if (feeds.empty()) feeds = chords_of_feeds(path);
    if (other_feeds.empty()) other_feeds = chords_of_feeds(other);
    return is_passed_once(feeds, path, common.move, within_mm) &&
           is_passed_once(other_feeds, other, common.other, within_mm);
  };
  std::vector<bool> is_left_out(path.moves.size());
  const auto skip = [&](const std::vector<Common>& all, std::size_t& at) {
    while (at < all.size() && is_left_out[all[at].move]) ++at;
  };
  std::size_t tried = 0, one = 0, two = 0;
  while (tried < kMaxTried) {
    skip(by_path, one);
    skip(by_other, two);
    if (one == by_path.size() || two == by_other.size()) return order;
    const Common &here = by_path[one], &there = by_other[two];
    if (here.move == there.move) {
      ++one;
      ++two;
      continue;
    }
    const bool is_here_certain = is_certain(here), is_there_certain = is_certain(there);
    if (is_here_certain && is_there_certain) {
      order.move = here.move;
      order.other = there.other;
      return order;
    }
    tried += 2;
    if (!is_here_certain) is_left_out[here.move] = true;
    if (!is_there_certain) is_left_out[there.move] = true;
    order.positions -= (is_here_certain ? 0U : 1U) + (is_there_certain ? 0U : 1U);
  }
  return order;
}

}  // namespace gouge

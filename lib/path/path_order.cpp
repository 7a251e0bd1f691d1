#include "lib/path/path_order.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "lib/path/motion_chords.h"
#include "lib/path/tip_grid.h"

namespace gouge {
namespace {

constexpr std::size_t kMaxTried = 1000;  // places at which feeds are searched for others that pass them

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

/// Decides whether a path passes the end of a feed once.
class Passes {
 public:
  Passes(const Toolpath& path, double within_mm) : path_(path), within_mm_(within_mm) {}

  /// Returns whether no feed passes the end of a move, except that move and the next feed, which begins there.
  [[nodiscard]] bool is_once(std::size_t move) {
    if (feeds_.empty()) feeds_ = chords_of_feeds(path_);
    const Pose& end = path_.moves[move].end;
    return std::ranges::none_of(feeds_, [&](const MotionChord& feed) {
      const bool is_own = feed.move == move || (feed.move == move + 1 && path_.moves[feed.move].has_start);
      return !is_own && tip_bound_mm(end, feed) <= within_mm_ && distance_from(end, feed).tip_mm <= within_mm_;
    });
  }

 private:
  const Toolpath& path_;
  double within_mm_;
  std::vector<MotionChord> feeds_;  // only made where the orders differ
};

/// Walks along the common positions in the order of each path.
class Walk {
 public:
  Walk(std::vector<Common> positions, std::size_t moves) : by_path_(std::move(positions)), is_left_out_(moves) {
    by_other_ = by_path_;
    std::ranges::sort(by_other_, {}, &Common::other);
  }

  /// Goes on to the next place at which the orders differ. Returns whether there is one.
  [[nodiscard]] bool find_difference() {
    for (;; ++one_, ++two_) {
      while (one_ < by_path_.size() && is_left_out_[by_path_[one_].move]) ++one_;
      while (two_ < by_other_.size() && is_left_out_[by_other_[two_].move]) ++two_;
      if (one_ == by_path_.size() || two_ == by_other_.size()) return false;
      if (by_path_[one_].move != by_other_[two_].move) return true;
    }
  }
  [[nodiscard]] const Common& in_path() const { return by_path_[one_]; }
  [[nodiscard]] const Common& in_other() const { return by_other_[two_]; }
  void leave_out(const Common& position) { is_left_out_[position.move] = true; }

 private:
  std::vector<Common> by_path_, by_other_;
  std::vector<bool> is_left_out_;  // by move of the path
  std::size_t one_ = 0, two_ = 0;
};

}  // namespace

PathOrder compare_order(const Toolpath& path, const Toolpath& other, double within_mm) {
  std::vector<Common> common = find_common(path, other, within_mm);
  PathOrder order{common.size()};
  Walk walk(std::move(common), path.moves.size());
  Passes passes(path, within_mm), other_passes(other, within_mm);
  for (std::size_t tried = 0; walk.find_difference(); ++tried) {
    if (tried == kMaxTried) return {};
    bool is_certain = true;
    for (const Common& position : {walk.in_path(), walk.in_other()}) {
      if (passes.is_once(position.move) && other_passes.is_once(position.other)) continue;
      walk.leave_out(position);
      --order.positions;
      is_certain = false;
    }
    if (!is_certain) continue;
    order.move = walk.in_path().move;
    order.other = walk.in_other().other;
    return order;
  }
  return order;
}

}  // namespace gouge

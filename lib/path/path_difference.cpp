#include "lib/path/path_difference.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "lib/base/tolerance.h"
#include "lib/path/chords.h"
#include "lib/path/path_info.h"

namespace gouge {
namespace {

constexpr double kChord_mm = 1e-4;  // of arcs and splines
// A motion this near among those that follow the last one ends the search; one at the same point ends it at once.
constexpr double kAlike_mm = 1e-3;
constexpr std::size_t kAhead = 200;  // motions after the last one in which the next is looked for first

/// A straight feed, or a chord of one.
struct FeedChord {
  Pose from, to;
  std::size_t move = 0;
};

// Rapids may be of a cycle.
bool is_compared(const Move& move) {
  return move.kind != MoveKind::rapid && move.feed_unit != FeedUnit::rapid && move.not_checked_reason.empty();
}

std::vector<FeedChord> feeds_of(const Toolpath& path) {
  std::vector<FeedChord> feeds;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const Move& move = path.moves[i];
    if (!is_compared(move)) continue;
    Pose from = move.has_start ? path.start_of(i) : move.end;
    if (move.has_start && move.curve_kind != CurveKind::none) {
      for (const Pose& to : chords_of(path, i, kChord_mm)) {
        feeds.push_back({from, to, i});
        from = to;
      }
    } else {
      feeds.push_back({from, move.end, i});
    }
  }
  return feeds;
}

/// Distances of a pose from the nearest point of a feed.
struct Distance {
  double tip_mm = std::numeric_limits<double>::infinity(), axis_rad = 0;
  [[nodiscard]] double sum(double height_mm) const { return tip_mm + height_mm * axis_rad; }
};

// The axis is that of the great circle at the nearest tip; where the tip rests, that which is nearer of both ends.
Distance distance_from(const Pose& pose, const FeedChord& feed) {
  const Vec3 way = feed.to.tip - feed.from.tip;
  const double squared = way.squaredNorm();
  const auto at = [&](double t) {
    return Distance{(feed.from.tip + t * way - pose.tip).norm(),
                    angle_between_rad(axis_between(feed.from.axis, feed.to.axis, t), pose.axis)};
  };
  if (squared > 0) return at(std::clamp((pose.tip - feed.from.tip).dot(way) / squared, 0.0, 1.0));
  const Distance first = at(0), last = at(1);
  return first.axis_rad < last.axis_rad ? first : last;
}

/// Lower bound of the distance without an angle.
double tip_bound_mm(const Pose& pose, const FeedChord& feed) {
  return (pose.tip - feed.to.tip).norm() - (feed.to.tip - feed.from.tip).norm();
}

class Nearest {
 public:
  Nearest(const std::vector<FeedChord>& feeds, double height_mm) : feeds_(feeds), height_mm_(height_mm) {}

  /// Returns the distance of the tip from the nearest feed, and the smallest angle at a feed as near, which `last` becomes.
  Distance find(const Pose& pose) {
    best_ = {};
    nearest_mm_ = std::numeric_limits<double>::infinity();
    const std::size_t ahead = std::min(feeds_.size(), last_ + kAhead);
    const std::size_t begin = begin_ = last_;
    const bool is_found = look_at(pose, begin, ahead, Tolerance::kSamePoint_mm) || best_.sum(height_mm_) < kAlike_mm ||
                          look_at(pose, ahead, feeds_.size(), kAlike_mm);
    if (!is_found) look_at(pose, 0, begin, kAlike_mm);
    return {nearest_mm_, best_.axis_rad};
  }
  [[nodiscard]] std::size_t move() const { return feeds_[last_].move; }
  /// Returns whether a motion that is as near as the nearest one fulfils a condition. Where a path passes a place more
  /// than once, several motions do. It looks at the motions that find() looks at first.
  template <class Condition>
  [[nodiscard]] bool has_alike(const Pose& pose, Condition fulfils) const {
    const std::size_t end = std::min(feeds_.size(), begin_ + kAhead);
    const double near_mm = std::max(kAlike_mm, best_.sum(height_mm_));
    for (std::size_t i = begin_; i < end; ++i) {
      if (tip_bound_mm(pose, feeds_[i]) > near_mm || !fulfils(feeds_[i].move)) continue;
      if (distance_from(pose, feeds_[i]).sum(height_mm_) <= near_mm) return true;
    }
    return false;
  }

 private:
  /// Looks for a nearer feed until one is nearer than `enough_mm`. Returns whether it found one.
  bool look_at(const Pose& pose, std::size_t begin, std::size_t end, double enough_mm) {
    for (std::size_t i = begin; i < end; ++i) {
      if (tip_bound_mm(pose, feeds_[i]) > nearest_mm_ + kAlike_mm) continue;
      const Distance found = distance_from(pose, feeds_[i]);
      if (found.tip_mm > nearest_mm_ + kAlike_mm) continue;
      nearest_mm_ = std::min(nearest_mm_, found.tip_mm);
      const bool is_best_near = best_.tip_mm <= nearest_mm_ + kAlike_mm;
      if (is_best_near && !(found.sum(height_mm_) < best_.sum(height_mm_))) continue;
      best_ = found;
      last_ = i;
      if (best_.sum(height_mm_) < enough_mm) return true;
    }
    return false;
  }

  const std::vector<FeedChord>& feeds_;
  double height_mm_;
  Distance best_;          // as near as nearest_mm_ within kAlike_mm
  double nearest_mm_ = 0;  // distance of the nearest tip
  std::size_t last_ = 0, begin_ = 0;
};

bool are_feeds_comparable(const Move& move, const Move& other) {
  const Feed one = move.feed(), two = other.feed();
  return one.is_number() && one.unit == two.unit && one.mm > 0 && two.mm > 0;
}

/// Returns whether one of both motions has a feed rate that the other one has not, or has in another unit.
bool has_unknown_feed(const Move& move, const Move& other) {
  const auto is_known = [](const Move& of) { return of.feed().is_number() && of.feed_mm > 0; };
  return !are_feeds_comparable(move, other) && (is_known(move) || is_known(other));
}

bool has_other_feed(const Move& move, const Move& other) {
  const Feed one = move.feed(), two = other.feed();
  if (!are_feeds_comparable(move, other)) return false;
  return std::abs(one.mm - two.mm) > PathDifference::kSameFeed * std::max(one.mm, two.mm);
}

}  // namespace

std::optional<PathDifference> measure_difference(const Toolpath& path, const Toolpath& other, double height_mm) {
  const std::vector<FeedChord> feeds = feeds_of(other);
  if (feeds.empty()) return std::nullopt;
  Nearest nearest(feeds, height_mm);
  PathDifference difference;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    if (!is_compared(path.moves[i])) continue;
    const Distance found = nearest.find(path.moves[i].end);
    ++difference.positions;
    if (difference.tip_move == kNone || found.tip_mm > difference.tip_mm) {
      difference.tip_mm = found.tip_mm;
      difference.tip_move = i;
      difference.tip_other = nearest.move();
    }
    if (difference.axis_move == kNone || found.axis_rad > difference.axis_rad) {
      difference.axis_rad = found.axis_rad;
      difference.axis_move = i;
      difference.axis_other = nearest.move();
    }
    if (has_unknown_feed(path.moves[i], other.moves[nearest.move()]) && difference.unknown_feeds++ == 0) {
      difference.unknown_move = i;
      difference.unknown_other = nearest.move();
    }
    const auto is_same_feed = [&](std::size_t move) { return !has_other_feed(path.moves[i], other.moves[move]); };
    if (is_same_feed(nearest.move()) || nearest.has_alike(path.moves[i].end, is_same_feed)) continue;
    if (difference.other_feeds++ > 0) continue;
    difference.feed_move = i;
    difference.feed_other = nearest.move();
  }
  return difference.positions > 0 ? std::optional(difference) : std::nullopt;
}

namespace {

std::vector<Vec3> tips_of(const Toolpath& path) {
  std::vector<Vec3> tips;
  for (const Move& move : path.moves)
    if (is_compared(move)) tips.push_back(move.end.tip);
  return tips;
}

Vec3 low_corner(const std::vector<Vec3>& tips) {
  Vec3 low = tips.front();
  for (const Vec3& tip : tips) low = low.cwiseMin(tip);
  return low;
}

PathRelation inverse(const PathRelation& r) { return {1 / r.factor, -r.shift_mm / r.factor}; }

/// Returns whether every tip lies near a feed after a relation. A few tips that are spread over the path come first: a
/// search of all feeds for every tip would be slow where the relation is wrong.
bool lie_on(const std::vector<FeedChord>& feeds, const std::vector<Vec3>& tips, const PathRelation& relation,
            double within_mm) {
  constexpr std::size_t kFew = 20;
  const auto lies_there = [&](Nearest& nearest, const Vec3& tip) {
    return nearest.find({relation.factor * tip + relation.shift_mm, Vec3::UnitZ()}).tip_mm <= within_mm;
  };
  const std::size_t step = std::max<std::size_t>(1, tips.size() / kFew);
  Nearest of_few(feeds, 0);
  for (std::size_t i = 0; i < tips.size(); i += step)
    if (!lies_there(of_few, tips[i])) return false;
  Nearest of_all(feeds, 0);
  return std::ranges::all_of(tips, [&](const Vec3& tip) { return lies_there(of_all, tip); });
}

}  // namespace

std::optional<PathRelation> find_relation(const Toolpath& path, const Toolpath& other, double within_mm) {
  constexpr double kMmPerInch = 25.4;
  constexpr std::size_t kMinTips = 3;  // a shift relates any two paths of one tip
  const std::vector<Vec3> tips = tips_of(path), other_tips = tips_of(other);
  if (std::min(tips.size(), other_tips.size()) < kMinTips) return std::nullopt;
  const std::vector<FeedChord> feeds = feeds_of(path), other_feeds = feeds_of(other);
  const auto relates = [&](const PathRelation& relation) {
    return lie_on(other_feeds, tips, relation, within_mm) && lie_on(feeds, other_tips, inverse(relation), within_mm);
  };
  if (relates({})) return std::nullopt;
  const PathRelation candidates[] = {{kMmPerInch, Vec3::Zero()},
                                     {1 / kMmPerInch, Vec3::Zero()},
                                     {1, other_tips.front() - tips.front()},
                                     {1, low_corner(other_tips) - low_corner(tips)}};
  const auto* const found = std::ranges::find_if(candidates, relates);
  return found == std::end(candidates) ? std::nullopt : std::optional(*found);
}

}  // namespace gouge

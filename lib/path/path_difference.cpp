#include "lib/path/path_difference.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "lib/base/tolerance.h"
#include "lib/path/chords.h"
#include "lib/path/farthest_tip.h"
#include "lib/path/motion_chords.h"
#include "lib/path/nearest_feed.h"
#include "lib/path/path_info.h"
#include "lib/path/rapid_places.h"
#include "lib/path/run_kind.h"

namespace gouge {
namespace {

constexpr std::size_t kAxesInside = 3;  // of a curved feed that are measured

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

/// Measures the feeds of a path in their order.
class Measurement {
 public:
  Measurement(const Toolpath& path, const Toolpath& other, const FeedsInBlocks& feeds, double height_mm,
              double within_mm)
      : path_(path),
        other_(other),
        nearest_(feeds, height_mm),
        nearest_to_middle_(feeds, height_mm),
        farthest_(feeds, std::max(within_mm, Tolerance::kSamePoint_mm)),
        rapids_(other, within_mm, height_mm),
        height_mm_(height_mm),
        within_mm_(within_mm) {}

  void add(std::size_t move) {
    ++result_.positions;
    const std::vector<MotionChord> chords = chords_of_move(path_, move);
    add_axes_inside(chords);
    PoseDistance found = nearest_.find(path_.moves[move].end);
    std::size_t at = nearest_.move();
    const std::size_t rapid = find_rapid(move, found);
    if (rapid != kNone) {
      if (path_.moves[move].has_start) add_rapid(move, rapid);  // else no motion to the position is known
      if (!found.is_within(within_mm_, height_mm_)) {
        found = distance_from(path_.moves[move].end, {start_of(other_, rapid), other_.moves[rapid].end, rapid});
        at = rapid;
      }
    }
    add_distance(move, found, at);
    if (rapid == kNone) add_tips_inside(chords);
    if (at == nearest_.move()) add_feed_rate(move);
  }
  [[nodiscard]] const PathDifference& result() const { return result_; }

 private:
  static Pose start_of(const Toolpath& path, std::size_t move) {
    return path.moves[move].has_start ? path.start_of(move) : path.moves[move].end;
  }

  /// Returns the rapid of the other path that this feed became, else kNone.
  std::size_t find_rapid(std::size_t move, const PoseDistance& found) {
    const Pose& end = path_.moves[move].end;
    const std::optional<Pose> middle = middle_of(move);
    if (found.is_within(within_mm_, height_mm_)) {
      const std::size_t rapid = middle ? rapids_.ending_at(end, *middle) : kNone;
      if (rapid == kNone || nearest_to_middle_.find(*middle).is_within(within_mm_, height_mm_)) return kNone;
      return rapid;
    }
    const std::size_t rapid = rapids_.ending_at(end);
    return rapid == kNone && middle ? rapids_.passing(*middle, end) : rapid;
  }

  /// None: the motion is not straight, or not known.
  [[nodiscard]] std::optional<Pose> middle_of(std::size_t move) const {
    const Move& of = path_.moves[move];
    if (!of.has_start || of.curve_kind != CurveKind::none) return std::nullopt;
    const Pose& start = path_.start_of(move);
    return Pose{0.5 * (start.tip + of.end.tip), axis_between(start.axis, of.end.axis, 0.5)};
  }

  void add_rapid(std::size_t move, std::size_t rapid) {
    const bool is_retract = leaves_along_axis(move);
    const bool is_first_cut = !is_retract && result_.rapids == result_.retracts;
    if (is_retract) ++result_.retracts;
    if (result_.rapids++ > 0 && !is_first_cut) return;
    result_.rapid_move = move;
    result_.rapid_other = rapid;
  }

  [[nodiscard]] bool leaves_along_axis(std::size_t move) const {
    const Pose start = start_of(path_, move), &end = path_.moves[move].end;
    const Vec3 way = end.tip - start.tip;
    return way.dot(start.axis) > 0 && way.cross(start.axis).norm() <= std::max(within_mm_, NearestFeed::kAlike_mm) &&
           height_mm_ * angle_between_rad(start.axis, end.axis) <= std::max(within_mm_, NearestFeed::kAlike_mm);
  }

  void add_axes_inside(const std::vector<MotionChord>& chords) {
    const std::size_t inside = chords.size() - 1, count = std::min(inside, kAxesInside);
    for (std::size_t k = 1; k <= count; ++k) {
      const MotionChord& chord = chords[k * inside / (count + 1)];
      const PoseDistance found = nearest_.find(chord.to);
      add_distance(chord.move, found, nearest_.move());
    }
  }

  void add_tips_inside(const std::vector<MotionChord>& chords) {
    for (const MotionChord& chord : chords) {
      if (!path_.moves[chord.move].has_start || !farthest_.add(chord.from.tip, chord.to.tip)) continue;
      if (farthest_.distance_mm() <= result_.tip_mm + Tolerance::kSamePoint_mm) continue;
      add_tip_distance(chord.move, farthest_.distance_mm(), farthest_.nearest_move());
      result_.is_tip_inside = true;
    }
  }

  void add_distance(std::size_t move, const PoseDistance& found, std::size_t at) {
    add_tip_distance(move, found.tip_mm, at);
    if (result_.axis_move == kNone || found.axis_rad > result_.axis_rad) {
      result_.axis_rad = found.axis_rad;
      result_.axis_move = move;
      result_.axis_other = at;
    }
  }

  void add_tip_distance(std::size_t move, double distance_mm, std::size_t at) {
    if (result_.tip_move != kNone && distance_mm <= result_.tip_mm) return;
    result_.tip_mm = distance_mm;
    result_.is_tip_inside = false;
    result_.tip_move = move;
    result_.tip_other = at;
  }

  void add_feed_rate(std::size_t move) {
    const std::size_t nearest = nearest_.move();
    if (has_unknown_feed(path_.moves[move], other_.moves[nearest]) && result_.unknown_feeds++ == 0) {
      result_.unknown_move = move;
      result_.unknown_other = nearest;
    }
    const auto is_same_feed = [&](std::size_t other) {
      return !has_other_feed(path_.moves[move], other_.moves[other]);
    };
    if (is_same_feed(nearest) || nearest_.has_alike(path_.moves[move].end, is_same_feed)) return;
    if (result_.other_feeds++ > 0) return;
    result_.feed_move = move;
    result_.feed_other = nearest;
  }

  const Toolpath &path_, &other_;
  NearestFeed nearest_, nearest_to_middle_;
  FarthestTip farthest_;
  RapidPlaces rapids_;
  double height_mm_, within_mm_;
  PathDifference result_;
};

}  // namespace

MovesLeftOut count_left_out(const Toolpath& path) {
  MovesLeftOut counts;
  const auto count = [](std::size_t& number, std::size_t& first, std::size_t move) {
    if (number++ == 0) first = move;
  };
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const Move& move = path.moves[i];
    if (move.not_checked_reason.empty()) {
      if (runs_rapid(move)) {
        count(counts.rapids, counts.first_rapid, i);
      } else {
        ++counts.feeds;
      }
      continue;
    }
    count(counts.unchecked, counts.first_unchecked, i);
    if (!runs_rapid(move) && counts.first_unchecked_feed == kNone) counts.first_unchecked_feed = i;
  }
  return counts;
}

std::optional<PathDifference> measure_difference(const Toolpath& path, const Toolpath& other, double height_mm,
                                                 double within_mm) {
  const FeedsInBlocks feeds(chords_of_feeds(other));
  if (feeds.all().empty()) return std::nullopt;
  Measurement measurement(path, other, feeds, height_mm, within_mm);
  for (std::size_t i = 0; i < path.moves.size(); ++i)
    if (is_checked_feed(path.moves[i])) measurement.add(i);
  return measurement.result().positions > 0 ? std::optional(measurement.result()) : std::nullopt;
}

namespace {

std::vector<Vec3> tips_of(const Toolpath& path) {
  std::vector<Vec3> tips;
  for (const Move& move : path.moves)
    if (is_checked_feed(move)) tips.push_back(move.end.tip);
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
bool lie_on(const FeedsInBlocks& feeds, const std::vector<Vec3>& tips, const PathRelation& relation, double within_mm) {
  constexpr std::size_t kFew = 20;
  const auto lies_there = [&](NearestFeed& nearest, const Vec3& tip) {
    return nearest.find({relation.factor * tip + relation.shift_mm, Vec3::UnitZ()}).tip_mm <= within_mm;
  };
  const std::size_t step = std::max<std::size_t>(1, tips.size() / kFew);
  NearestFeed of_few(feeds, 0);
  for (std::size_t i = 0; i < tips.size(); i += step)
    if (!lies_there(of_few, tips[i])) return false;
  NearestFeed of_all(feeds, 0);
  return std::ranges::all_of(tips, [&](const Vec3& tip) { return lies_there(of_all, tip); });
}

}  // namespace

std::optional<PathRelation> find_relation(const Toolpath& path, const Toolpath& other, double within_mm) {
  constexpr double kMmPerInch = 25.4;
  constexpr std::size_t kMinTips = 3;  // a shift relates any two paths of one tip
  const std::vector<Vec3> tips = tips_of(path), other_tips = tips_of(other);
  if (std::min(tips.size(), other_tips.size()) < kMinTips) return std::nullopt;
  const FeedsInBlocks feeds(chords_of_feeds(path)), other_feeds(chords_of_feeds(other));
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

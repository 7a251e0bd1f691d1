#include "lib/tilt/feed_directions.h"

#include <algorithm>
#include <optional>

#include "lib/base/tolerance.h"
#include "lib/geom/shortest_turn.h"

namespace gouge {
namespace {

using Positions = std::vector<TiltPosition>;

constexpr double kAlongAxis = 1e-3;  // a smaller share of a motion across the tool axis gives no direction
constexpr double kSameFeed = 0.98;   // cosine of the maximum turn of the feed that is no corner; 11 degrees

Vec3 across_axis(const Vec3& way, const Vec3& axis) { return way - way.dot(axis) * axis; }

/// Returns the part of a motion across the tool axis; nothing if the motion is along the axis.
std::optional<Vec3> feed_direction(const Positions& all, std::size_t from, std::size_t to, const Vec3& axis) {
  const Vec3 feed = all[to].programmed.tip - all[from].programmed.tip;
  const Vec3 across = across_axis(feed, axis);
  const bool has_direction = across.norm() > kAlongAxis * feed.norm() && across.norm() > Tolerance::kNoSide;
  return has_direction ? std::optional(across) : std::nullopt;
}

std::optional<Vec3> direction_after(const Positions& all, std::size_t i) {
  return i + 1 < all.size() ? feed_direction(all, i, i + 1, all[i].programmed.axis) : std::nullopt;
}

void set_first(TiltPosition& at, const Vec3& direction) {
  at.first = across_axis(direction, at.programmed.axis).normalized();
}

/// Gives position `to` the direction of its neighbour `from`, turned only as much as the axis turns.
void carry(Positions& all, std::size_t from, std::size_t to) {
  set_first(all[to], shortest_turn(all[from].programmed.axis, all[to].programmed.axis) * all[from].first);
}

/// Returns the position from `begin` to `end` that is farthest from all motions that are not clean.
std::size_t farthest_from_collisions(const Positions& all, std::size_t begin, std::size_t end) {
  constexpr double kFar_mm = 1e300;
  const auto away_mm = [&](std::size_t i) {
    double away = kFar_mm;
    for (std::size_t k = 1; k < all.size(); ++k) {
      if (all[k].is_reached_clean) continue;
      const double at = all[i].arc_length_mm;
      away = std::min(away, std::max({0.0, all[k - 1].arc_length_mm - at, at - all[k].arc_length_mm}));
    }
    return away;
  };
  std::size_t farthest = begin;
  for (std::size_t i = begin + 1; i <= end; ++i) {
    if (away_mm(i) > away_mm(farthest)) farthest = i;
  }
  return farthest;
}

/// Follows the feed from position `begin`, at which a pass ends or the run begins, to `end`, at which the next one
/// begins or the run ends. All motions between the two are along the axis, if there are any.
void follow_between_passes(Positions& all, std::size_t begin, std::size_t end) {
  const std::optional<Vec3> before = begin > 0 ? direction_after(all, begin - 1) : std::nullopt,
                            after = direction_after(all, end);
  std::size_t turn = before ? end : begin;  // the last position with the direction of the pass before
  if (before && after && before->dot(*after) < kSameFeed * before->norm() * after->norm()) {
    turn = farthest_from_collisions(all, begin, end);
    all[turn].given = Tilt::Zero();
  }
  const bool is_alone = begin == end;
  if (is_alone) {
    const auto both =
        feed_direction(all, begin > 0 ? begin - 1 : 0, std::min(end + 1, all.size() - 1), all[begin].programmed.axis);
    if (both) set_first(all[begin], *both);
    if (!both && begin > 0) carry(all, begin - 1, begin);
    return;
  }
  if (before) set_first(all[begin], *before);
  if (after) set_first(all[end], *after);
  for (std::size_t i = begin + 1; before && i <= turn && (i < end || !after); ++i) carry(all, i - 1, i);
  for (std::size_t i = end; after && i > (before ? turn + 1 : begin); --i) carry(all, i, i - 1);
}

}  // namespace

void follow_feed(Positions& positions) {
  for (std::size_t begin = 0, end = 0; begin < positions.size(); begin = end + 1) {
    end = begin;
    while (end + 1 < positions.size() && !direction_after(positions, end)) ++end;
    follow_between_passes(positions, begin, end);
  }
}

}  // namespace gouge

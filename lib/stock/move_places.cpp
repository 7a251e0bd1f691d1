#include "lib/stock/move_places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "lib/base/tolerance.h"
#include "lib/tool/evaluate.h"

namespace gouge {

namespace {

// An interval of time is halved at most this often for one region; the region is then too near to the tool.
constexpr int kMaxHalvings = 12;
constexpr int kFirstInstants = 3, kMaxInstants = 12, kRefinements = 6;

}  // namespace

Vec3 outward_of(const CompiledTool& tool, const Pose& pose, const Vec3& point) {
  const Vec3 from_tip = point - pose.tip;
  const double z = from_tip.dot(pose.axis);
  const Vec3 across = from_tip - z * pose.axis;
  const double r = across.norm();
  const Vec2 normal = evaluate(tool, r, z).normal;
  const Vec3 out = r > 0 ? Vec3(across / r) : Vec3(pose.axis.unitOrthogonal());
  return normal.x() * out + normal.y() * pose.axis;
}

double MovePlaces::way_mm(double a, double b, const Vec3& point) const {
  if (!motion_) return (b - a) * by_.norm();
  const double length = motion_->path_length_mm(a, b, segment_), turn = motion_->turn_rad(a, b);
  return turn > 0 ? length + turn * ((point - motion_->tip_at(a, segment_)).norm() + length) : length;
}

std::optional<MovePlaces::Nearest> MovePlaces::nearest(const CompiledTool& tool, double a, double b, const Vec3& point,
                                                       double most_mm) const {
  const auto distance = [&](double t) { return signed_distance_mm(tool, at(t), point); };
  Nearest best{0, 0.5 * (a + b)};
  best.distance_mm = distance(best.t);
  const double way = way_mm(a, b, point);
  if (best.distance_mm - way >= most_mm) return std::nullopt;
  if (best.distance_mm - std::max(way_mm(a, best.t, point), way_mm(best.t, b, point)) >= most_mm) return std::nullopt;
  const auto take = [&](double t) {
    const double here = distance(t);
    if (here < best.distance_mm) best = {here, t};
  };
  const int first =
      std::clamp(static_cast<int>(2 * way / std::max(tool.r_max_mm, Tolerance::kNoSide)), kFirstInstants, kMaxInstants);
  for (int k = 0; k <= first; ++k) take(a + (b - a) * k / first);
  double step = (b - a) / first;
  for (int k = 0; k < kRefinements; ++k) {
    step *= 0.5;
    const double about = best.t;
    take(std::max(a, about - step));
    take(std::min(b, about + step));
  }
  if (best.distance_mm >= most_mm) return std::nullopt;
  return best;
}

bool MovePlaces::is_apart(const CompiledTool& tool, const std::vector<ContourHull>& hulls, double a, double b,
                          const HullRegion& region, double slack_mm, Vec3& away) const {
  Asked asked{tool, hulls, region, region.middle(), 0, slack_mm + Tolerance::kRounding_mm};
  asked.ball_mm = region.reach_mm(asked.middle) + asked.slack_mm;
  return is_apart(asked, a, b, kMaxHalvings, away);
}

MovePlaces::Swept MovePlaces::swept(double a, double b) const {
  Swept swept{at(a), at(b), 0, 0};
  if (!motion_ || motion_->is_alone()) return swept;
  const MotionRates rates = motion_->rates(a, b, segment_);
  swept.axis_off = rates.axis_acceleration_rad() / 8 + rates.off_circle_rad;
  swept.tip_off_mm = rates.tip_sag_mm;
  return swept;
}

bool MovePlaces::is_apart(const Asked& asked, double a, double b, int halvings, Vec3& away) const {
  const double middle = 0.5 * (a + b);
  const double distance = signed_distance_mm(asked.tool, at(middle), asked.middle);
  if (distance < 0) return false;
  if (distance - std::max(way_mm(a, middle, asked.middle), way_mm(middle, b, asked.middle)) > asked.ball_mm)
    return true;
  const Swept swept = this->swept(a, b);
  // Every point of a hull at a pose is on a circle about the axis. Its coordinate along a direction is a convex function of
  // the axis, so over a chord of axes it is largest at an end. The axis and the tip are near their chords.
  const auto is_behind = [&](const ContourHull& hull, const Vec3& direction, double lowest) {
    return std::max(hull.highest_mm(direction, swept.first), hull.highest_mm(direction, swept.last)) +
               2 * swept.axis_off * hull.reach_mm + swept.tip_off_mm + asked.slack_mm <
           lowest;
  };
  const auto lowest_along = [&](const Vec3& direction) {
    double lowest = std::numeric_limits<double>::max();
    for (const Vec3& point : asked.region.points()) lowest = std::min(lowest, direction.dot(point));
    return lowest;
  };
  const auto are_behind = [&](const Vec3& direction) {
    const double lowest = lowest_along(direction);
    return std::ranges::all_of(asked.hulls,
                               [&](const ContourHull& hull) { return is_behind(hull, direction, lowest); });
  };
  if (!away.isZero(0) && are_behind(away)) return true;
  const std::optional<Nearest> nearest =
      this->nearest(asked.tool, a, b, asked.middle, std::numeric_limits<double>::max());
  if (!nearest || nearest->distance_mm < 0) return false;
  const Pose pose = at(nearest->t);
  const Vec3 outward = outward_of(asked.tool, pose, asked.middle);
  if (are_behind(outward)) {
    away = outward;
    return true;
  }
  const Vec3 from_tip = asked.middle - pose.tip, from_axis = from_tip - from_tip.dot(pose.axis) * pose.axis;
  const bool has_side = from_axis.norm() > Tolerance::kNoDirection;
  const std::array<Vec3, 4> directions{outward, has_side ? Vec3(from_axis.normalized()) : outward, pose.axis,
                                       Vec3(-pose.axis)};
  std::array<double, 4> lowest{};
  for (std::size_t k = 0; k < directions.size(); ++k) lowest[k] = lowest_along(directions[k]);
  const bool is_apart_now = std::ranges::all_of(asked.hulls, [&](const ContourHull& hull) {
    for (std::size_t k = 0; k < directions.size(); ++k)
      if (is_behind(hull, directions[k], lowest[k])) return true;
    return false;
  });
  if (is_apart_now) return true;
  if (halvings == 0) return false;
  return is_apart(asked, a, middle, halvings - 1, away) && is_apart(asked, middle, b, halvings - 1, away);
}

}  // namespace gouge

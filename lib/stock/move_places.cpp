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
constexpr int kFirstInstants = 3, kMostInstants = 12, kRefinements = 8;

/// Returns the direction in which the distance from the tool grows at a point.
Vec3 outward_of(const CompiledTool& tool, const Pose& pose, const Vec3& point) {
  const Vec3 from_tip = point - pose.tip;
  const double z = from_tip.dot(pose.axis);
  const Vec3 across = from_tip - z * pose.axis;
  const double r = across.norm();
  const Vec2 normal = evaluate(tool, r, z).normal;
  const Vec3 out = r > 0 ? Vec3(across / r) : Vec3(pose.axis.unitOrthogonal());
  return normal.x() * out + normal.y() * pose.axis;
}

}  // namespace

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
  const auto take = [&](double t) {
    const double here = distance(t);
    if (here < best.distance_mm) best = {here, t};
  };
  const int first = std::clamp(static_cast<int>(2 * way / std::max(tool.r_max_mm, Tolerance::kNoSide)), kFirstInstants,
                               kMostInstants);
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
                          const ConvexRegion& region, double slack_mm) const {
  Asked asked{tool, hulls, region, region.middle(), 0, slack_mm + Tolerance::kRounding_mm};
  asked.ball_mm = region.reach_mm(asked.middle) + asked.slack_mm;
  return is_apart(asked, a, b, kMaxHalvings);
}

bool MovePlaces::is_apart(const Asked& asked, double a, double b, int halvings) const {
  const double middle = 0.5 * (a + b);
  const double distance = signed_distance_mm(asked.tool, at(middle), asked.middle);
  if (distance < 0) return false;
  if (distance - std::max(way_mm(a, middle, asked.middle), way_mm(middle, b, asked.middle)) > asked.ball_mm)
    return true;
  const std::optional<Nearest> nearest =
      this->nearest(asked.tool, a, b, asked.middle, std::numeric_limits<double>::max());
  if (!nearest || nearest->distance_mm < 0) return false;
  if (is_behind_planes(asked, a, b, nearest->t)) return true;
  if (halvings == 0) return false;
  return is_apart(asked, a, middle, halvings - 1) && is_apart(asked, middle, b, halvings - 1);
}

// Every point of the hull at a pose is on a circle about the axis. Its coordinate along the plane's direction is a convex
// function of the axis, so over a chord of axes it is largest at an end; the axis and the tip are near their chords.
bool MovePlaces::is_behind_planes(const Asked& asked, double a, double b, double t) const {
  const Pose pose = at(t), first = at(a), last = at(b);
  const Vec3 from_axis = asked.middle - pose.tip - (asked.middle - pose.tip).dot(pose.axis) * pose.axis;
  std::array<Vec3, 4> directions{outward_of(asked.tool, pose, asked.middle), pose.axis, -pose.axis, pose.axis};
  if (from_axis.norm() > Tolerance::kNoDirection) directions[3] = from_axis.normalized();
  std::array<double, 4> lowest;
  for (std::size_t k = 0; k < directions.size(); ++k) {
    lowest[k] = std::numeric_limits<double>::max();
    for (const Vec3& point : asked.region.points()) lowest[k] = std::min(lowest[k], directions[k].dot(point));
  }
  double axis_off = 0, tip_off = asked.slack_mm;
  if (motion_ && !motion_->is_alone()) {
    const MotionRates rates = motion_->rates(a, b, segment_);
    axis_off = rates.axis_acceleration_rad() / 8 + rates.off_circle_rad;
    tip_off += rates.tip_sag_mm;
  }
  return std::ranges::all_of(asked.hulls, [&](const ContourHull& hull) {
    for (std::size_t k = 0; k < directions.size(); ++k) {
      const double highest = std::max(hull.highest_mm(directions[k], first), hull.highest_mm(directions[k], last)) +
                             2 * axis_off * hull.reach_mm + tip_off;
      if (highest < lowest[k]) return true;
    }
    return false;
  });
}

}  // namespace gouge

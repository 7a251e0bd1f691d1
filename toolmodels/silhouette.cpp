#include "toolmodels/silhouette.h"

#include <algorithm>
#include <vector>

namespace gouge {
namespace {

constexpr double kSameHeight_mm = 1e-3;
constexpr int kSteps = 256;

std::vector<Vec2> outline(const Profile& profile) {
  std::vector<Vec2> points;
  for (const ProfileElement& element : profile.elements) {
    for (const Vec2& point : sample(element, element.is_arc ? kSteps : 1)) points.push_back(point);
  }
  return points;
}

// The widest point of the piece from `a` to `b` within `low` to `high`; negative where none of it is there.
double widest_within(const Vec2& a, const Vec2& b, double low, double high) {
  const Vec2& bottom = a.y() < b.y() ? a : b;
  const Vec2& top = a.y() < b.y() ? b : a;
  if (bottom.y() > high || top.y() < low) return -1;
  const double rise = top.y() - bottom.y();
  if (!(rise > 0)) return std::max(a.x(), b.x());
  const auto at = [&](double z) {
    const double t = std::clamp((z - bottom.y()) / rise, 0.0, 1.0);
    return bottom.x() + t * (top.x() - bottom.x());
  };
  return std::max(at(low), at(high));
}

double widest_at(const std::vector<Vec2>& points, double z) {
  double widest = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    widest = std::max(widest, widest_within(points[i - 1], points[i], z - kSameHeight_mm, z + kSameHeight_mm));
  }
  return widest;
}

}  // namespace

// Between two corners of both outlines the difference runs straight, so its largest value is at a corner of one.
double reach_beyond_mm(const Cutter& cutter, const Cutter& other) {
  const Result<Profile> mine = make_cutter_profile(cutter), theirs = make_cutter_profile(other);
  if (!mine || !theirs) return 0;
  const std::vector<Vec2> points = outline(*mine), others = outline(*theirs);
  const double height = std::min(length_mm(cutter), length_mm(other));
  std::vector<double> heights = {height};
  for (const std::vector<Vec2>* corners : {&points, &others}) {
    for (const Vec2& corner : *corners) {
      if (corner.y() >= 0 && corner.y() <= height) heights.push_back(corner.y());
    }
  }
  double reach = 0;
  for (const double z : heights) {
    double widest = 0;
    for (std::size_t i = 1; i < points.size(); ++i)
      widest = std::max(widest, widest_within(points[i - 1], points[i], z, z));
    reach = std::max(reach, widest - widest_at(others, z));
  }
  return reach;
}

}  // namespace gouge

#include "toolmodels/silhouette.h"

#include <algorithm>
#include <vector>

#include "lib/base/tolerance.h"
#include "toolmodels/box_tree.h"

namespace gouge {
namespace {

constexpr int kSteps = 256;

std::vector<Vec2> profile_outline(const Profile& profile) {
  std::vector<Vec2> points;
  for (const ProfileElement& element : profile.elements) {
    for (const Vec2& point : sample(element, element.is_arc ? kSteps : 1)) points.push_back(point);
  }
  return points;
}

// Returns the largest radius of the piece from `a` to `b` between the heights `low` and `high`; negative if the piece
// does not reach them.
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

// The largest radius of an outline within a range of heights; negative where the outline does not reach them.
class Widths {
 public:
  explicit Widths(const std::vector<Vec2>& points) : points_(points), tree_(boxes_of(points)) {}

  [[nodiscard]] double within(double low, double high) const {
    double widest = -1;
    tree_.for_each_meeting({Vec2(-1e300, low), Vec2(1e300, high)}, [&](std::size_t i) {
      widest = std::max(widest, widest_within(points_[i], points_[i + 1], low, high));
    });
    return widest;
  }

 private:
  static std::vector<Eigen::AlignedBox2d> boxes_of(const std::vector<Vec2>& points) {
    std::vector<Eigen::AlignedBox2d> boxes;
    for (std::size_t i = 1; i < points.size(); ++i)
      boxes.push_back(Eigen::AlignedBox2d(points[i - 1]).extend(points[i]));
    return boxes;
  }

  const std::vector<Vec2>& points_;
  detail::BoxTree tree_;
};

}  // namespace

// Between neighbouring corner heights of both outlines the difference is linear, so its maximum is at a corner height.
double reach_beyond_mm(const Cutter& cutter, const Cutter& other) {
  const Result<Profile> mine = make_cutter_profile(cutter), theirs = make_cutter_profile(other);
  if (!mine || !theirs) return 0;
  const std::vector<Vec2> points = profile_outline(*mine), others = profile_outline(*theirs);
  const double height = std::min(length_mm(cutter), length_mm(other));
  std::vector<double> heights = {height};
  for (const std::vector<Vec2>* corners : {&points, &others}) {
    for (const Vec2& corner : *corners) {
      if (corner.y() >= 0 && corner.y() <= height) heights.push_back(corner.y());
    }
  }
  double reach = 0;
  const Widths own(points), other_widths(others);
  for (const double z : heights) {
    const double beside =
        std::max(0.0, other_widths.within(z - Tolerance::kFilePoint_mm, z + Tolerance::kFilePoint_mm));
    reach = std::max(reach, std::max(0.0, own.within(z, z)) - beside);
  }
  return reach;
}

}  // namespace gouge

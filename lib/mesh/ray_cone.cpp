#include "lib/mesh/ray_cone.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "lib/base/tolerance.h"

namespace gouge {

namespace {

// slack_ and volume_slack_ cover the rounding of triple products: a few units in the last place of |a| |b| for corners
// a, b seen from the origin.

}  // namespace

RayCone::RayCone(const std::array<Vec3, 3>& triangle, const Vec3& origin) {
  std::array<double, 3> length;
  for (std::size_t k = 0; k < 3; ++k) {
    corners_[k] = triangle[k] - origin;
    length[k] = corners_[k].norm();
  }
  for (std::size_t k = 0; k < 3; ++k) {
    sides_[k] = corners_[k].cross(corners_[(k + 1) % 3]);
    slack_[k] = Tolerance::kFewRoundings * length[k] * length[(k + 1) % 3];
  }
  volume_ = sides_[0].dot(corners_[2]);
  volume_slack_ = Tolerance::kFewRoundings * length[0] * length[1] * length[2];
}

RayCrossing RayCone::crossing(const Vec3& direction) const {
  bool has_left = false, has_right = false, is_doubtful = false;
  for (std::size_t k = 0; k < 3; ++k) {
    const double turn = sides_[k].dot(direction);
    has_left = has_left || turn > slack_[k];
    has_right = has_right || turn < -slack_[k];
    is_doubtful = is_doubtful || std::abs(turn) <= slack_[k];
  }
  if (has_left && has_right) return RayCrossing::none;  // the line passes beside the triangle
  const bool is_behind = std::all_of(corners_.begin(), corners_.end(), [&](const Vec3& c) {
    return c.dot(direction) < -Tolerance::kFewRoundings * c.norm();
  });
  if (is_behind) return RayCrossing::none;
  if (is_doubtful || std::abs(volume_) <= volume_slack_) return RayCrossing::doubtful;
  const bool is_ahead = has_left == (volume_ > 0);
  if (!is_ahead) return RayCrossing::none;
  return has_left ? RayCrossing::out : RayCrossing::in;
}

bool has_free_ray(const IndexedMesh& mesh, std::span<const Vec3> origins, std::span<const Vec3> directions) {
  std::vector<std::vector<Vec3>> open(origins.size());
  for (std::vector<Vec3>& own : open) {
    for (const Vec3& d : directions) own.push_back(d.normalized());
  }
  std::size_t left = origins.size() * directions.size();
  for (std::size_t t = 0; t < mesh.triangles.size() && left > 0; ++t) {
    for (std::size_t o = 0; o < origins.size(); ++o) {
      if (open[o].empty()) continue;
      const RayCone cone({mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)}, origins[o]);
      left -= std::erase_if(open[o], [&](const Vec3& d) { return cone.crossing(d) != RayCrossing::none; });
    }
  }
  return left > 0;
}

}  // namespace gouge

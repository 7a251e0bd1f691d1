#include "lib/mesh/free_ray.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace gouge {
namespace {

// A triple product of corners a, b seen from the origin is off by a few units in the last place of |a| |b|.
constexpr double kRounding = 1e-12;

/// A triangle as an origin sees it.
struct Cone {
  std::array<Vec3, 3> corners, sides;
  std::array<double, 3> slack;
  double volume = 0, volume_slack = 0;

  Cone(const IndexedMesh& mesh, std::size_t t, const Vec3& origin) {
    std::array<double, 3> length;
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = mesh.corner(t, k) - origin;
      length[k] = corners[k].norm();
    }
    for (std::size_t k = 0; k < 3; ++k) {
      sides[k] = corners[k].cross(corners[(k + 1) % 3]);
      slack[k] = kRounding * length[k] * length[(k + 1) % 3];
    }
    volume = sides[0].dot(corners[2]);
    volume_slack = kRounding * length[0] * length[1] * length[2];
  }

  /// False only when a ray in this unit direction misses the triangle beyond doubt.
  [[nodiscard]] bool may_meet(const Vec3& direction) const {
    bool has_left = false, has_right = false, is_doubtful = false;
    for (std::size_t k = 0; k < 3; ++k) {
      const double turn = sides[k].dot(direction);
      has_left = has_left || turn > slack[k];
      has_right = has_right || turn < -slack[k];
      is_doubtful = is_doubtful || std::abs(turn) <= slack[k];
    }
    if (has_left && has_right) return false;  // the line passes beside it
    const bool is_behind = std::all_of(corners.begin(), corners.end(),
                                       [&](const Vec3& c) { return c.dot(direction) < -kRounding * c.norm(); });
    if (is_behind) return false;
    // The line crosses the triangle's plane behind the origin.
    if (!is_doubtful && has_left && volume < -volume_slack) return false;
    return is_doubtful || !has_right || volume <= volume_slack;
  }
};

}  // namespace

bool has_free_ray(const IndexedMesh& mesh, std::span<const Vec3> origins, std::span<const Vec3> directions) {
  std::vector<std::vector<Vec3>> open(origins.size());
  for (std::vector<Vec3>& own : open) {
    for (const Vec3& d : directions) own.push_back(d.normalized());
  }
  std::size_t left = origins.size() * directions.size();
  for (std::size_t t = 0; t < mesh.triangles.size() && left > 0; ++t) {
    for (std::size_t o = 0; o < origins.size(); ++o) {
      if (open[o].empty()) continue;
      const Cone cone(mesh, t, origins[o]);
      left -= std::erase_if(open[o], [&](const Vec3& d) { return cone.may_meet(d); });
    }
  }
  return left > 0;
}

}  // namespace gouge

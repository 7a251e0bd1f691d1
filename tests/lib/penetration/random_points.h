#pragma once

#include <cstdint>
#include <vector>

#include "lib/geom/pose.h"
#include "lib/mesh/indexed_mesh.h"
#include "tests/support/scatter.h"

// Points on both sides of a surface and near it, and rigid motions, from a seed.

namespace gouge {

class RandomPoints {
 public:
  RandomPoints(const IndexedMesh& mesh, double depth_mm, std::uint64_t seed)
      : mesh_(mesh), depth_mm_(depth_mm), random_(seed) {}

  /// Up to 1.2 times the depth from a point of a random triangle: one in three from its rim or near it.
  Vec3 next() {
    const std::size_t t = random_.next() % mesh_.triangles.size();
    double u = uniform(), v = uniform();
    if (u + v > 1) {
      u = 1 - u;
      v = 1 - v;
    }
    const std::uint64_t kind = random_.next() % 6;
    if (kind == 0) v *= 1e-3;
    if (kind == 1) u = v = 0;
    const Vec3 &a = mesh_.corner(t, 0), &b = mesh_.corner(t, 1), &c = mesh_.corner(t, 2);
    const Vec3 at = a + u * (b - a) + v * (c - a);
    const Vec3 axis = kind < 4 ? direction() : Vec3((b - a).cross(c - a).normalized());
    return at + (1.2 * depth_mm_ * (2 * uniform() - 1)) * axis;
  }

  RigidTransform pose(double reach_mm) {
    RigidTransform pose;
    pose.rotation = Eigen::AngleAxisd(6.3 * uniform(), direction()).toRotationMatrix();
    pose.shift = reach_mm * uniform() * direction();
    return pose;
  }

  double uniform() { return random_.in(0, 1); }
  Vec3 direction() { return random_.direction(); }

 private:
  const IndexedMesh& mesh_;
  double depth_mm_;
  test::Scatter random_;
};

}  // namespace gouge

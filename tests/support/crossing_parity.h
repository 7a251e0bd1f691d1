#pragma once

#include <cmath>
#include <cstddef>

#include "lib/mesh/indexed_mesh.h"

// An inside test for tests only: counts how often a ray leaves a closed solid, with the textbook method of Moeller and
// Trumbore. The direction of the ray must hit no edge. Header only.

namespace gouge::test {

inline bool is_inside(const IndexedMesh& closed, const Vec3& point) {
  const Vec3 d = Vec3(0.5377, 0.2318, 0.8106).normalized();
  std::size_t hits = 0;
  for (std::size_t t = 0; t < closed.triangles.size(); ++t) {
    const Vec3 a = closed.corner(t, 0), e1 = closed.corner(t, 1) - a, e2 = closed.corner(t, 2) - a;
    const Vec3 h = d.cross(e2);
    const double det = e1.dot(h);
    if (std::abs(det) < 1e-14) continue;
    const Vec3 s = point - a, q = s.cross(e1);
    const double u = s.dot(h) / det, v = d.dot(q) / det;
    if (u >= 0 && v >= 0 && u + v <= 1 && e2.dot(q) / det > 0) ++hits;
  }
  return hits % 2 == 1;
}

}  // namespace gouge::test

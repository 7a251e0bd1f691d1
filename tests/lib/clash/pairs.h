#pragma once

#include <memory>
#include <utility>

#include "lib/clash/clash_body.h"
#include "tests/support/scatter.h"
#include "tests/support/solids.h"

// Pairs of bodies for tests of clashes. Header only.

namespace gouge::test {

inline DepthBody index_of(const IndexedMesh& mesh) {
  DepthBodyOptions options;
  options.directions = *make_directions(DirectionFamily::cube, 6);
  options.is_lean = true;
  return build_depth_body(mesh, options);
}

inline IndexedMesh placed(IndexedMesh mesh, const Vec3& axis, double angle_rad, const Vec3& shift) {
  const Eigen::Matrix3d rotation = Eigen::AngleAxisd(angle_rad, axis.normalized()).toRotationMatrix();
  for (Vec3& vertex : mesh.vertices) vertex = rotation * vertex + shift;
  return mesh;
}

struct Pair {
  Pair(const IndexedMesh& of_a, const IndexedMesh& of_b)
      : surfaces(std::make_unique<std::pair<DepthBody, DepthBody>>(index_of(of_a), index_of(of_b))),
        a(surfaces->first),
        b(surfaces->second) {}

  std::unique_ptr<std::pair<DepthBody, DepthBody>> surfaces;
  ClashBody a, b;
};

/// One of seven shapes that are not convex, about 20 mm large.
inline IndexedMesh random_solid(Scatter& random) {
  switch (static_cast<int>(random.in(0, 7))) {
    case 0:
      return shapes::star_prism(3 + static_cast<std::size_t>(random.in(0, 5)), 12, random.in(3, 8),
                                random.in(3, 14));
    case 1:
      return shapes::slotted_block(random.in(0.5, 4), random.in(2, 9), random.in(6, 14), random.in(8, 20));
    case 2:
      return shapes::bumpy_sphere(10, random.in(0.5, 3), 8, 14);
    case 3:
      return shapes::torus(random.in(7, 10), random.in(1.5, 4), 14, 8);
    case 4:
      return shapes::hollow_cube(random.in(8, 16));
    case 5:
      return shapes::joined(shapes::moved(shapes::cube(random.in(3, 8)), Vec3(-10, -4, -4)),
                            shapes::moved(shapes::tetrahedron(random.in(5, 12)), Vec3(1, -4, -4)));
    default:
      return shapes::refined(shapes::slotted_block(2, 5, 10, 12), 1);
  }
}

inline IndexedMesh random_place(Scatter& random, const IndexedMesh& mesh, double apart) {
  return placed(mesh, random.axis(1), random.in(-3, 3), random.point(apart));
}

/// Two of them, turned and shifted so that most overlap.
inline Pair random_pair(unsigned seed) {
  Scatter random(seed);
  const IndexedMesh a = random_place(random, random_solid(random), 2);
  return {a, random_place(random, random_solid(random), 11)};
}

}  // namespace gouge::test

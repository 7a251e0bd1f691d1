#pragma once

#include <algorithm>
#include <array>
#include <utility>

#include "lib/clash/clash_body.h"
#include "tests/support/scatter.h"
#include "tests/support/solids.h"

// Pairs of bodies for tests of clashes. Header only.

namespace gouge::test {

inline IndexedMesh placed(IndexedMesh mesh, const Vec3& axis, double angle_rad, const Vec3& shift) {
  const Eigen::Matrix3d rotation = Eigen::AngleAxisd(angle_rad, axis.normalized()).toRotationMatrix();
  for (Vec3& vertex : mesh.vertices) vertex = rotation * vertex + shift;
  return mesh;
}

struct Pair {
  Pair(IndexedMesh of_a, IndexedMesh of_b) : a(Surface(std::move(of_a))), b(Surface(std::move(of_b))) {}

  ClashBody a, b;
};

/// One of seven shapes that are not convex, about 20 mm large.
inline IndexedMesh random_solid(Scatter& random) {
  const std::size_t kind = random.below(7), points = 3 + random.below(5);
  const double a = random.in(0, 1), b = random.in(0, 1), c = random.in(0, 1), d = random.in(0, 1);
  switch (kind) {
    case 0:
      return shapes::star_prism(points, 12, 3 + 5 * a, 3 + 11 * b);
    case 1:
      return shapes::slotted_block(0.5 + 3.5 * a, 2 + 7 * b, 6 + 8 * c, 8 + 12 * d);
    case 2:
      return shapes::bumpy_sphere(10, 0.5 + 2.5 * a, 8, 14);
    case 3:
      return shapes::torus(7 + 3 * a, 1.5 + 2.5 * b, 14, 8);
    case 4:
      return shapes::hollow_cube(8 + 8 * a);
    case 5:
      return shapes::joined(shapes::moved(shapes::cube(3 + 5 * a), Vec3(-10, -4, -4)),
                            shapes::moved(shapes::tetrahedron(5 + 7 * b), Vec3(1, -4, -4)));
    default:
      return shapes::refined(shapes::slotted_block(2, 5, 10, 12), 1);
  }
}

inline IndexedMesh random_place(Scatter& random, const IndexedMesh& mesh, double apart) {
  const Vec3 axis = random.direction(), shift = random.point(apart);
  return placed(mesh, axis, random.in(-3, 3), shift);
}

/// Two of them, turned and shifted so that most overlap.
inline Pair random_pair(unsigned seed) {
  Scatter random(seed);
  const IndexedMesh a = random_place(random, random_solid(random), 2);
  return {a, random_place(random, random_solid(random), 11)};
}

/// Unit cubes of a lattice of 4 x 4 x 4, filled or not.
struct LatticeSolid {
  static constexpr int kSide = 4;
  std::array<bool, kSide * kSide * kSide> is_filled{};

  explicit LatticeSolid(Scatter& random) {
    const double share = random.in(0.2, 0.9);
    for (bool& filled : is_filled) filled = random.is(share);
    is_filled[0] = true;
  }
  [[nodiscard]] bool at(int x, int y, int z) const {
    const bool is_within = std::min({x, y, z}) >= 0 && std::max({x, y, z}) < kSide;
    return is_within && is_filled[static_cast<std::size_t>((z * kSide + y) * kSide + x)];
  }

  /// Its surface: cubes may touch along edges and at corners alone.
  [[nodiscard]] IndexedMesh mesh() const {
    IndexedMesh mesh;
    mesh.name = "lattice";
    constexpr int kCorners = kSide + 1;
    std::vector<std::size_t> vertex_at(kCorners * kCorners * kCorners, ~std::size_t{0});
    const auto vertex = [&](const Eigen::Vector3i& p) {
      std::size_t& index = vertex_at[static_cast<std::size_t>((p.z() * kCorners + p.y()) * kCorners + p.x())];
      if (index == ~std::size_t{0}) {
        index = mesh.vertices.size();
        mesh.vertices.push_back(p.cast<double>());
      }
      return index;
    };
    for (int i = 0; i < kSide * kSide * kSide; ++i) {
      const Eigen::Vector3i cube(i % kSide, i / kSide % kSide, i / (kSide * kSide));
      if (!at(cube.x(), cube.y(), cube.z())) continue;
      for (int axis = 0; axis < 3; ++axis) {
        const Eigen::Vector3i along = Eigen::Vector3i::Unit(axis), u = Eigen::Vector3i::Unit((axis + 1) % 3),
                              v = Eigen::Vector3i::Unit((axis + 2) % 3), below = cube - along, above = cube + along;
        if (!at(below.x(), below.y(), below.z()))
          shapes::add_quad(mesh, vertex(cube), vertex(cube + v), vertex(cube + u + v), vertex(cube + u));
        if (!at(above.x(), above.y(), above.z()))
          shapes::add_quad(mesh, vertex(above), vertex(above + u), vertex(above + u + v), vertex(above + v));
      }
    }
    return mesh;
  }
};

}  // namespace gouge::test

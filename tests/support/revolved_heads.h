#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "tests/support/shapes.h"
#include "tests/support/solids.h"

namespace gouge::test {

/// Returns the mesh of a contour (r, z), from the axis to the axis, that is turned about the axis in `sides` steps.
inline IndexedMesh turned(const std::vector<Vec2>& contour, std::size_t sides) {
  IndexedMesh mesh;
  for (std::size_t i = 0; i < contour.size(); ++i) {
    const bool is_end = i == 0 || i + 1 == contour.size();
    for (std::size_t k = 0; k < (is_end ? 1 : sides); ++k) {
      const double a = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(sides);
      mesh.vertices.push_back({contour[i].x() * std::cos(a), contour[i].x() * std::sin(a), contour[i].y()});
    }
  }
  const auto vertex = [&](std::size_t ring, std::size_t k) {
    if (ring == 0) return std::size_t{0};
    return ring + 1 == contour.size() ? mesh.vertices.size() - 1 : 1 + (ring - 1) * sides + k % sides;
  };
  for (std::size_t i = 0; i + 1 < contour.size(); ++i) {
    for (std::size_t k = 0; k < sides; ++k) {
      if (i > 0) shapes::add_triangle(mesh, vertex(i, k), vertex(i, k + 1), vertex(i + 1, k + 1));
      if (i + 2 < contour.size()) shapes::add_triangle(mesh, vertex(i, k), vertex(i + 1, k + 1), vertex(i + 1, k));
    }
  }
  return mesh;
}

/// Returns heads that fill much of the space through which they turn, from 5 mm above the tip on. They are a rounded
/// cylinder, a spindle nose with a neck and a flange, a bumpy ball and a box about the axis. Others are two drums with
/// a gap between them, and a ring with an empty middle.
inline std::vector<IndexedMesh> heads_around_the_axis() {
  std::vector<Vec2> rounded{{0, 5}};
  for (int i = 0; i <= 12; ++i) {
    const double a = i * std::numbers::pi / 24;
    rounded.push_back({10 + 6 * std::sin(a), 11 - 6 * std::cos(a)});
  }
  rounded.insert(rounded.end(), {{16, 40}, {0, 40}});
  std::vector<IndexedMesh> all;
  const auto add = [&](IndexedMesh mesh, const char* name) {
    mesh.name = name;
    all.push_back(std::move(mesh));
  };
  add(turned(rounded, 40), "rounded");
  add(turned({{0, 5}, {8, 5}, {8, 20}, {14, 30}, {9, 30}, {9, 36}, {25, 36}, {25, 48}, {0, 48}}, 17), "spindle");
  add(shapes::moved(shapes::bumpy_sphere(14, 2, 10, 16), {0, 0, 21}), "bumpy");
  add(shapes::box({-12, -9, 5}, {10, 11, 30}), "box");
  add(shapes::joined(turned({{0, 5}, {14, 5}, {14, 12}, {0, 12}}, 9),
                     turned({{0, 20}, {10, 20}, {15, 30}, {0, 31}}, 12)),
      "drums");
  add(shapes::moved(shapes::torus(12, 6, 20, 10), {0, 0, 11}), "ring");
  return all;
}

}  // namespace gouge::test

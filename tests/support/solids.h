#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/shapes.h"

// Closed solids that are far from convex, for tests of the shallow-penetration core. Header only.

namespace gouge::shapes {

/// Returns a prism over a star of `points` points: acute edges, reflex edges, vertices with edges of both kinds.
inline IndexedMesh star_prism(std::size_t points = 5, double outer = 20, double inner = 8, double height = 12) {
  IndexedMesh mesh;
  mesh.name = "star";
  const std::size_t n = 2 * points;
  for (const double z : {0.0, height}) {
    for (std::size_t i = 0; i < n; ++i) {
      const double angle = std::numbers::pi * static_cast<double>(i) / static_cast<double>(points);
      const double r = i % 2 == 0 ? outer : inner;
      mesh.vertices.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
    }
  }
  mesh.vertices.emplace_back(0, 0, 0);
  mesh.vertices.emplace_back(0, 0, height);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = (i + 1) % n;
    add_quad(mesh, i, next, n + next, n + i);
    add_triangle(mesh, 2 * n, next, i);
    add_triangle(mesh, 2 * n + 1, n + i, n + next);
  }
  return mesh;
}

/// Returns a sphere whose radius varies with both angles: hills, hollows and saddles.
inline IndexedMesh bumpy_sphere(double radius = 30, double bump = 4, std::size_t rings = 24, std::size_t sectors = 50) {
  IndexedMesh mesh = sphere(radius, rings, sectors);
  mesh.name = "bumpy sphere";
  for (Vec3& v : mesh.vertices) {
    const double longitude = std::atan2(v.y(), v.x()), latitude = std::asin(v.z() / radius);
    v *= 1 + bump / radius * std::sin(5 * longitude) * std::cos(4 * latitude) * std::cos(latitude);
  }
  return mesh;
}

/// Returns a block with a slot along y that is open at the top; its walls are `wall` thick.
inline IndexedMesh slotted_block(double wall = 1, double slot = 6, double height = 10, double length = 20) {
  const std::vector<std::pair<double, double>> outline = {{0, 0},
                                                          {2 * wall + slot, 0},
                                                          {2 * wall + slot, height},
                                                          {wall + slot, height},
                                                          {wall + slot, wall},
                                                          {wall, wall},
                                                          {wall, height},
                                                          {0, height}};
  const std::vector<std::array<std::size_t, 4>> faces = {{0, 5, 6, 7}, {0, 1, 4, 5}, {1, 2, 3, 4}};
  IndexedMesh mesh;
  mesh.name = "slotted block";
  const std::size_t n = outline.size();
  for (const double y : {0.0, length}) {
    for (const auto& [x, z] : outline) mesh.vertices.emplace_back(x, y, z);
  }
  for (std::size_t i = 0; i < n; ++i) add_quad(mesh, i, n + i, n + (i + 1) % n, (i + 1) % n);
  for (const auto& f : faces) {
    add_quad(mesh, f[0], f[1], f[2], f[3]);
    add_quad(mesh, n + f[3], n + f[2], n + f[1], n + f[0]);
  }
  return mesh;
}

/// Returns the square [-half, half]^2 at z = 0 with a front and a back, whose diagonals differ: a closed surface without
/// duplicate triangles that encloses nothing.
inline IndexedMesh closed_sheet(double half) {
  IndexedMesh mesh;
  mesh.name = "closed sheet";
  mesh.vertices = {{-half, -half, 0}, {half, -half, 0}, {half, half, 0}, {-half, half, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
  mesh.file_triangle = {1, 2, 3, 4};
  return mesh;
}

/// Returns a block [-half, half]^2 x [-height, 0] with a blind hole of `radius` and `depth` about z. The hole has
/// `corners` flat walls, a multiple of 8, and its corners lie on the radius.
inline IndexedMesh bored_block(double radius, double depth, double half = 50, double height = 30,
                               std::size_t corners = 64) {
  IndexedMesh mesh;
  mesh.name = "bored block";
  const std::size_t n = corners;
  std::vector<Vec3> round, square;
  for (std::size_t k = 0; k < n; ++k) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(n);
    const Vec3 away(std::cos(angle), std::sin(angle), 0);
    round.push_back(radius * away);
    square.push_back(half / std::max(std::abs(away.x()), std::abs(away.y())) * away);
  }
  const auto ring = [&](const std::vector<Vec3>& at, double z) {
    for (const Vec3& point : at) mesh.vertices.emplace_back(point.x(), point.y(), z);
  };
  ring(square, -height);
  ring(square, 0);
  ring(round, 0);
  ring(round, -depth);
  mesh.vertices.emplace_back(0, 0, -height);
  mesh.vertices.emplace_back(0, 0, -depth);
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t next = (k + 1) % n;
    for (std::size_t level = 0; level < 3; ++level)
      add_quad(mesh, level * n + k, level * n + next, (level + 1) * n + next, (level + 1) * n + k);
    add_triangle(mesh, 4 * n, next, k);
    add_triangle(mesh, 3 * n + k, 3 * n + next, 4 * n + 1);
  }
  return mesh;
}

/// Returns the mesh with every triangle cut into four, `times` times; the surface stays the same.
inline IndexedMesh refined(const IndexedMesh& coarse, int times) {
  if (times == 0) return coarse;
  IndexedMesh all;
  all.name = coarse.name;
  std::vector<std::pair<std::pair<Corner, Corner>, std::size_t>> middles;
  all.vertices = coarse.vertices;
  for (const TriangleCorners& t : coarse.triangles) {
    for (std::size_t k = 0; k < 3; ++k) middles.push_back({std::minmax(t[k], t[(k + 1) % 3]), 0});
  }
  std::sort(middles.begin(), middles.end());
  middles.erase(std::unique(middles.begin(), middles.end()), middles.end());
  for (auto& [edge, place] : middles) {
    place = all.vertices.size();
    all.vertices.emplace_back(0.5 * (coarse.vertices[edge.first] + coarse.vertices[edge.second]));
  }
  const auto middle = [&](Corner a, Corner b) {
    const std::pair<std::pair<Corner, Corner>, std::size_t> wanted = {std::minmax(a, b), 0};
    return std::lower_bound(middles.begin(), middles.end(), wanted)->second;
  };
  for (const TriangleCorners& t : coarse.triangles) {
    const std::size_t ab = middle(t[0], t[1]), bc = middle(t[1], t[2]), ca = middle(t[2], t[0]);
    add_triangle(all, t[0], ab, ca);
    add_triangle(all, ab, t[1], bc);
    add_triangle(all, ca, bc, t[2]);
    add_triangle(all, ab, bc, ca);
  }
  return refined(all, times - 1);
}

}  // namespace gouge::shapes

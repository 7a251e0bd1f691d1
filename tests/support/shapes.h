#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

#include "lib/mesh/indexed_mesh.h"

// Named small meshes for tests: mm, triangles counter-clockwise seen from outside unless the name states otherwise.
// Header only: include it, and link lib/mesh or a library that uses it.

namespace gouge::shapes {

/// Adds a triangle by its corner indices. Its index in the file is its place in the list.
inline void add_triangle(IndexedMesh& mesh, std::size_t a, std::size_t b, std::size_t c) {
  mesh.file_triangle.push_back(static_cast<std::uint32_t>(mesh.triangles.size()));
  mesh.triangles.push_back({static_cast<Corner>(a), static_cast<Corner>(b), static_cast<Corner>(c)});
}

/// Adds a quadrilateral a b c d (counter-clockwise) as the triangles a b c and a c d.
inline void add_quad(IndexedMesh& mesh, std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
  add_triangle(mesh, a, b, c);
  add_triangle(mesh, a, c, d);
}

/// Returns a closed box of 8 vertices and 12 triangles. The last two triangles are the top (z = high.z).
inline IndexedMesh box(const Vec3& low, const Vec3& high) {
  IndexedMesh mesh;
  mesh.name = "box";
  for (int i = 0; i < 8; ++i) {
    mesh.vertices.emplace_back((i & 1) != 0 ? high.x() : low.x(), (i & 2) != 0 ? high.y() : low.y(),
                               (i & 4) != 0 ? high.z() : low.z());
  }
  add_quad(mesh, 0, 2, 3, 1);
  add_quad(mesh, 0, 1, 5, 4);
  add_quad(mesh, 1, 3, 7, 5);
  add_quad(mesh, 3, 2, 6, 7);
  add_quad(mesh, 2, 0, 4, 6);
  add_quad(mesh, 4, 5, 7, 6);
  return mesh;
}

/// Returns the cube [0, size]^3.
inline IndexedMesh cube(double size = 10) { return box(Vec3::Zero(), Vec3::Constant(size)); }

/// Returns a cube without its top; it has 4 boundary edges.
inline IndexedMesh open_cube(double size = 10) {
  IndexedMesh mesh = cube(size);
  mesh.triangles.resize(10);
  mesh.file_triangle.resize(10);
  return mesh;
}

/// Returns a tetrahedron with corners at the origin and at `size` on each axis; its volume is size^3 / 6.
inline IndexedMesh tetrahedron(double size = 10) {
  IndexedMesh mesh;
  mesh.name = "tetrahedron";
  mesh.vertices = {Vec3::Zero(), Vec3(size, 0, 0), Vec3(0, size, 0), Vec3(0, 0, size)};
  add_triangle(mesh, 0, 2, 1);
  add_triangle(mesh, 0, 1, 3);
  add_triangle(mesh, 1, 2, 3);
  add_triangle(mesh, 2, 0, 3);
  return mesh;
}

/// Returns the same surface with every triangle turned over.
inline IndexedMesh inside_out(IndexedMesh mesh) {
  for (TriangleCorners& corners : mesh.triangles) std::swap(corners[1], corners[2]);
  return mesh;
}

/// Returns the mesh moved by `shift`.
inline IndexedMesh moved(IndexedMesh mesh, const Vec3& shift) {
  for (Vec3& v : mesh.vertices) v += shift;
  return mesh;
}

/// Returns both meshes in one. Vertices with equal coordinates become one, as in welding.
inline IndexedMesh joined(IndexedMesh mesh, const IndexedMesh& other) {
  std::vector<std::size_t> place;
  for (const Vec3& v : other.vertices) {
    const auto same = std::find_if(mesh.vertices.begin(), mesh.vertices.end(),
                                   [&](const Vec3& w) { return (v - w).cwiseAbs().maxCoeff() <= 0; });
    place.push_back(static_cast<std::size_t>(same - mesh.vertices.begin()));
    if (same == mesh.vertices.end()) mesh.vertices.push_back(v);
  }
  for (const TriangleCorners& t : other.triangles) add_triangle(mesh, place[t[0]], place[t[1]], place[t[2]]);
  return mesh;
}

/// Returns two cubes that share exactly one edge, which four triangles use (not manifold).
inline IndexedMesh cubes_touching_at_edge(double size = 10) {
  return joined(cube(size), moved(cube(size), Vec3(size, size, 0)));
}

/// Returns two cubes that share exactly one vertex.
inline IndexedMesh cubes_touching_at_vertex(double size = 10) {
  return joined(cube(size), moved(cube(size), Vec3::Constant(size)));
}

/// Returns two cubes, the second shifted by half a size along each axis; their surfaces cross.
inline IndexedMesh cubes_crossing(double size = 10) {
  return joined(cube(size), moved(cube(size), Vec3::Constant(size / 2)));
}

/// Returns a cube with a cubic cavity in its middle (two shells, one solid).
inline IndexedMesh hollow_cube(double size = 10) {
  return joined(cube(size), inside_out(box(Vec3::Constant(size / 4), Vec3::Constant(size * 3 / 4))));
}

/// Returns a sphere about the origin by latitude and longitude; vertices lie on the sphere.
inline IndexedMesh sphere(double radius = 10, std::size_t rings = 16, std::size_t sectors = 32) {
  IndexedMesh mesh;
  mesh.name = "sphere";
  mesh.vertices.emplace_back(0, 0, -radius);
  for (std::size_t i = 1; i < rings; ++i) {
    const double latitude = std::numbers::pi * (static_cast<double>(i) / static_cast<double>(rings) - 0.5);
    for (std::size_t j = 0; j < sectors; ++j) {
      const double longitude = 2 * std::numbers::pi * static_cast<double>(j) / static_cast<double>(sectors);
      mesh.vertices.emplace_back(radius * std::cos(latitude) * std::cos(longitude),
                                 radius * std::cos(latitude) * std::sin(longitude), radius * std::sin(latitude));
    }
  }
  mesh.vertices.emplace_back(0, 0, radius);
  const std::size_t top = mesh.vertices.size() - 1;
  for (std::size_t j = 0; j < sectors; ++j) {
    const std::size_t next = (j + 1) % sectors;
    add_triangle(mesh, 0, 1 + next, 1 + j);
    for (std::size_t i = 0; i + 2 < rings; ++i) {
      const std::size_t row = 1 + i * sectors;
      add_quad(mesh, row + j, row + next, row + sectors + next, row + sectors + j);
    }
    add_triangle(mesh, top, top - sectors + j, top - sectors + next);
  }
  return mesh;
}

/// Returns a ring about the z axis (genus 1).
inline IndexedMesh torus(double major = 20, double minor = 5, std::size_t around = 24, std::size_t tube = 12) {
  IndexedMesh mesh;
  mesh.name = "torus";
  for (std::size_t i = 0; i < around; ++i) {
    const double u = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(around);
    for (std::size_t j = 0; j < tube; ++j) {
      const double v = 2 * std::numbers::pi * static_cast<double>(j) / static_cast<double>(tube);
      const double r = major + minor * std::cos(v);
      mesh.vertices.emplace_back(r * std::cos(u), r * std::sin(u), minor * std::sin(v));
    }
  }
  for (std::size_t i = 0; i < around; ++i) {
    for (std::size_t j = 0; j < tube; ++j) {
      const std::size_t a = i * tube;
      const std::size_t b = (i + 1) % around * tube;
      const std::size_t next = (j + 1) % tube;
      add_quad(mesh, a + j, b + j, b + next, a + next);
    }
  }
  return mesh;
}

/// Returns a closed cone with its base in z = 0 and its apex at (0, 0, height). For a large n its 2 n triangles are
/// needles.
inline IndexedMesh needle_fan(std::size_t n = 720, double radius = 10, double height = 5) {
  IndexedMesh mesh;
  mesh.name = "needle fan";
  mesh.vertices = {Vec3(0, 0, height), Vec3::Zero()};
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
    mesh.vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
  }
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t a = 2 + i;
    const std::size_t b = 2 + (i + 1) % n;
    add_triangle(mesh, 0, a, b);
    add_triangle(mesh, 1, b, a);
  }
  return mesh;
}

/// Returns an open horizontal rectangle [0, x] x [0, y] at height z that looks up, cut into nx by ny quadrilaterals.
inline IndexedMesh sheet(double x, double y, double z, std::size_t nx = 1, std::size_t ny = 1) {
  IndexedMesh mesh;
  mesh.name = "sheet";
  for (std::size_t j = 0; j <= ny; ++j) {
    for (std::size_t i = 0; i <= nx; ++i) {
      mesh.vertices.emplace_back(x * static_cast<double>(i) / static_cast<double>(nx),
                                 y * static_cast<double>(j) / static_cast<double>(ny), z);
    }
  }
  for (std::size_t j = 0; j < ny; ++j) {
    for (std::size_t i = 0; i < nx; ++i) {
      const std::size_t a = j * (nx + 1) + i;
      add_quad(mesh, a, a + 1, a + nx + 2, a + nx + 1);
    }
  }
  return mesh;
}

}  // namespace gouge::shapes

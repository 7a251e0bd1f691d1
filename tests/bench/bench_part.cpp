#include "tests/bench/bench_part.h"

#include <cmath>
#include <numbers>
#include <vector>

namespace gouge::bench {
namespace {

Vec3 rounded(double x, double y, double z) {
  return {static_cast<double>(static_cast<float>(x)), static_cast<double>(static_cast<float>(y)),
          static_cast<double>(static_cast<float>(z))};
}

Corner add(IndexedMesh& mesh, const Vec3& p) {
  mesh.vertices.push_back(p);
  return static_cast<Corner>(mesh.vertices.size() - 1);
}

void add_triangle(IndexedMesh& mesh, Corner a, Corner b, Corner c) {
  mesh.file_triangle.push_back(static_cast<std::uint32_t>(mesh.triangles.size()));
  mesh.triangles.push_back({a, b, c});
}

/// Walls from the rim (counter-clockwise seen from above) down to z = 0, and a fan as the floor.
void close_below(IndexedMesh& mesh, const std::vector<Corner>& rim, const Vec3& middle) {
  std::vector<Corner> base;
  for (const Corner c : rim) {
    const Vec3 p = mesh.vertices[c];
    base.push_back(add(mesh, {p.x(), p.y(), 0}));
  }
  const Corner hub = add(mesh, rounded(middle.x(), middle.y(), 0));
  for (std::size_t k = 0; k < rim.size(); ++k) {
    const std::size_t next = (k + 1) % rim.size();
    add_triangle(mesh, rim[k], base[k], base[next]);
    add_triangle(mesh, rim[k], base[next], rim[next]);
    add_triangle(mesh, hub, base[next], base[k]);
  }
}

}  // namespace

IndexedMesh make_block(const Height& height, double side_mm, std::size_t triangles) {
  // 2 n^2 on top, 8 n in the walls, 4 n in the floor.
  const auto n = static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(triangles) / 2 + 9) - 3));
  IndexedMesh mesh;
  mesh.name = "block";
  const auto at = [n](std::size_t i, std::size_t j) { return static_cast<Corner>(i * (n + 1) + j); };
  for (std::size_t i = 0; i <= n; ++i) {
    for (std::size_t j = 0; j <= n; ++j) {
      const double x = side_mm * static_cast<double>(i) / static_cast<double>(n);
      const double y = side_mm * static_cast<double>(j) / static_cast<double>(n);
      add(mesh, rounded(x, y, height(x, y)));
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      add_triangle(mesh, at(i, j), at(i + 1, j), at(i + 1, j + 1));
      add_triangle(mesh, at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  }
  std::vector<Corner> rim;
  for (std::size_t k = 0; k < n; ++k) rim.push_back(at(k, 0));
  for (std::size_t k = 0; k < n; ++k) rim.push_back(at(n, k));
  for (std::size_t k = n; k > 0; --k) rim.push_back(at(k, n));
  for (std::size_t k = n; k > 0; --k) rim.push_back(at(0, k));
  close_below(mesh, rim, {side_mm / 2, side_mm / 2, 0});
  return mesh;
}

IndexedMesh make_disc(const Height& height, double radius_mm, std::size_t triangles) {
  // With m rings and 4 m spokes: 8 m^2 - 4 m on top, 12 m below.
  const auto m = static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(triangles) / 8)));
  const std::size_t spokes = 4 * m;
  IndexedMesh mesh;
  mesh.name = "disc";
  const Corner top = add(mesh, rounded(0, 0, height(0, 0)));
  const auto at = [spokes](std::size_t ring, std::size_t k) {
    return static_cast<Corner>(1 + (ring - 1) * spokes + k % spokes);
  };
  for (std::size_t ring = 1; ring <= m; ++ring) {
    const double r = radius_mm * static_cast<double>(ring) / static_cast<double>(m);
    for (std::size_t k = 0; k < spokes; ++k) {
      const double turn = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(spokes);
      const double x = r * std::cos(turn), y = r * std::sin(turn);
      add(mesh, rounded(x, y, height(x, y)));
    }
  }
  for (std::size_t k = 0; k < spokes; ++k) add_triangle(mesh, top, at(1, k), at(1, k + 1));
  for (std::size_t ring = 1; ring < m; ++ring) {
    for (std::size_t k = 0; k < spokes; ++k) {
      add_triangle(mesh, at(ring, k), at(ring + 1, k), at(ring + 1, k + 1));
      add_triangle(mesh, at(ring, k), at(ring + 1, k + 1), at(ring, k + 1));
    }
  }
  std::vector<Corner> rim;
  for (std::size_t k = 0; k < spokes; ++k) rim.push_back(at(m, k));
  close_below(mesh, rim, Vec3::Zero());
  return mesh;
}

Vec3 normal_at(const Height& height, double x_mm, double y_mm) {
  constexpr double kStep_mm = 1e-4;
  const double dx = (height(x_mm + kStep_mm, y_mm) - height(x_mm - kStep_mm, y_mm)) / (2 * kStep_mm);
  const double dy = (height(x_mm, y_mm + kStep_mm) - height(x_mm, y_mm - kStep_mm)) / (2 * kStep_mm);
  return Vec3(-dx, -dy, 1).normalized();
}

}  // namespace gouge::bench

#include "lib/mesh/chord_error.h"

#include <algorithm>
#include <numbers>
#include <unordered_map>
#include <utility>

namespace gouge {
namespace {

constexpr double kSharp_rad = std::numbers::pi / 6;

std::uint64_t edge_key(Corner a, Corner b) {
  const auto [low, high] = std::minmax(a, b);
  return (std::uint64_t{low} << 32U) | high;
}

/// A triangle of interest beside an edge, and the vertex of it that is not on the edge.
struct Side {
  std::size_t triangle = 0, target = 0;
  Corner apex = 0;
};

double height_mm(const IndexedMesh& mesh, Corner a, Corner b, Corner apex) {
  const Vec3 along = mesh.vertices[b] - mesh.vertices[a];
  const double length = along.norm();
  return length > 0 ? along.cross(mesh.vertices[apex] - mesh.vertices[a]).norm() / length : 0;
}

double error_at_edge_mm(const IndexedMesh& mesh, const Side& side, std::size_t neighbour, Corner a, Corner b,
                        Corner neighbour_apex) {
  const Vec3 n = face_normal(mesh, side.triangle), m = face_normal(mesh, neighbour);
  const double angle = std::atan2(n.cross(m).norm(), n.dot(m));
  const bool is_hollow = n.dot(mesh.vertices[neighbour_apex] - mesh.vertices[a]) > 0;
  if (!is_hollow || !(angle < kSharp_rad)) return 0;
  const double h = height_mm(mesh, a, b, side.apex), k = height_mm(mesh, a, b, neighbour_apex);
  const double largest = std::max(h, k);
  return h + k > 0 ? largest * largest * angle / (4 * (h + k)) : 0;
}

}  // namespace

std::vector<double> estimate_chord_errors_mm(const IndexedMesh& mesh, std::span<const std::uint32_t> file_triangles) {
  std::vector<double> errors(file_triangles.size(), 0);
  std::unordered_multimap<std::uint64_t, Side> sides;
  std::vector<bool> is_corner(mesh.vertices.size(),
                              false);  // of a triangle of interest; few triangles have two of them
  const auto for_each_edge = [&](std::size_t triangle, const auto& take) {
    const TriangleCorners& corners = mesh.triangles[triangle];
    for (std::size_t k = 0; k < 3; ++k) take(corners[k], corners[(k + 1) % 3], corners[(k + 2) % 3]);
  };
  for (std::size_t target = 0; target < file_triangles.size(); ++target) {
    const auto found = std::ranges::lower_bound(mesh.file_triangle, file_triangles[target]);
    if (found == mesh.file_triangle.end() || *found != file_triangles[target]) continue;
    const auto triangle = static_cast<std::size_t>(found - mesh.file_triangle.begin());
    for_each_edge(triangle, [&](Corner a, Corner b, Corner apex) {
      sides.emplace(edge_key(a, b), Side{triangle, target, apex});
      is_corner[a] = true;
    });
  }
  for (std::size_t i = 0; i < mesh.triangles.size() && !sides.empty(); ++i)
    for_each_edge(i, [&](Corner a, Corner b, Corner apex) {
      if (!is_corner[a] || !is_corner[b]) return;
      const auto [first, last] = sides.equal_range(edge_key(a, b));
      for (auto side = first; side != last; ++side) {
        double& error = errors[side->second.target];
        if (side->second.triangle != i) error = std::max(error, error_at_edge_mm(mesh, side->second, i, a, b, apex));
      }
    });
  return errors;
}

}  // namespace gouge

#include "lib/mesh/join_vertices.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include "lib/base/number_text.h"

namespace gouge {
namespace {

using Cell = std::array<std::int64_t, 3>;

struct HashOfCell {
  std::size_t operator()(const Cell& cell) const {
    std::uint64_t mixed = 0;
    for (const std::int64_t k : cell) {
      mixed = (mixed ^ static_cast<std::uint64_t>(k)) * 0x9e3779b97f4a7c15ULL;
      mixed ^= mixed >> 32;
    }
    return mixed;
  }
};

// Vertices that stay, stored in cubes as wide as the reach. All vertices within the reach are in the 27 cubes around.
class Stayers {
 public:
  Stayers(const std::vector<Vec3>& vertices, double reach_mm) : vertices_(vertices), reach_mm_(reach_mm) {}

  // Returns the nearest vertex within reach, or `vertex` itself, which then stays.
  Corner nearest_or_add(Corner vertex) {
    const Vec3& at = vertices_[vertex];
    const Cell middle = cell_of(at);
    Corner nearest = vertex;
    double least = reach_mm_;
    for (std::int64_t k = 0; k < 27; ++k) {
      const auto found = cells_.find({middle[0] + k % 3 - 1, middle[1] + k / 3 % 3 - 1, middle[2] + k / 9 - 1});
      if (found == cells_.end()) continue;
      for (const Corner other : found->second) {
        const double distance = (vertices_[other] - at).norm();
        if (distance < least || (distance <= least && (nearest == vertex || other < nearest))) {
          nearest = other;
          least = distance;
        }
      }
    }
    if (nearest == vertex) cells_[middle].push_back(vertex);
    return nearest;
  }

 private:
  [[nodiscard]] Cell cell_of(const Vec3& at) const {
    Cell cell{};
    for (std::size_t k = 0; k < 3; ++k)
      cell[k] = static_cast<std::int64_t>(std::floor(at[static_cast<Eigen::Index>(k)] / reach_mm_));
    return cell;
  }

  const std::vector<Vec3>& vertices_;
  double reach_mm_;
  std::unordered_map<Cell, std::vector<Corner>, HashOfCell> cells_;
};

}  // namespace

Result<JoinedMesh> join_near_vertices(const IndexedMesh& mesh, double reach_mm) {
  JoinedMesh joined;
  Stayers stayers(mesh.vertices, reach_mm);
  std::vector<Corner> slot(mesh.vertices.size());
  for (Corner v = 0; v < slot.size(); ++v) {
    slot[v] = stayers.nearest_or_add(v);
    if (slot[v] == v) continue;
    ++joined.vertices_joined;
    joined.largest_shift_mm = std::max(joined.largest_shift_mm, (mesh.vertices[slot[v]] - mesh.vertices[v]).norm());
  }
  TriangleSoup soup;
  soup.name = mesh.name;
  soup.triangles.reserve(mesh.triangles.size());
  for (const TriangleCorners& t : mesh.triangles)
    soup.triangles.push_back({mesh.vertices[slot[t[0]]], mesh.vertices[slot[t[1]]], mesh.vertices[slot[t[2]]]});
  Result<BuiltMesh> built = build_mesh(soup);
  if (!built) {
    return make_error("mesh-weld",
                      "every triangle collapses when vertices within " + exact_text(reach_mm) +
                          " mm are joined; expected a distance well below the part's details",
                      mesh.name);
  }
  // Replaces the triangle numbers of the soup by those of the file.
  for (std::uint32_t& number : built->mesh.file_triangle) number = mesh.file_triangle[number];
  for (MeshSpot* spot : {&built->degenerate, &built->collinear}) {
    if (spot->count > 0) spot->file_triangle = mesh.file_triangle[spot->file_triangle];
  }
  joined.triangles_collapsed = built->degenerate.count;
  joined.findings = find_mesh_findings(*built);
  joined.mesh = std::move(built->mesh);
  return joined;
}

}  // namespace gouge

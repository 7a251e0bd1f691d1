#include "lib/remains/region_mesh.h"

#include <algorithm>
#include <unordered_map>
#include <vector>

namespace gouge {

namespace {

// A point of an edge is left out if it is nearer than this to the plane of the four points in the cells around it, mm.
constexpr double kFlat_mm = 1e-7;

class MeshMaker {
 public:
  MeshMaker(const RegionPoints& points, MeshOf side) : points_(points), side_(side) {}

  [[nodiscard]] IndexedMesh run(const std::vector<std::uint64_t>& cells) {
    for (const std::uint64_t key : cells) {
      const GridIndex cell = grid_index(key);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        // An edge that is divided is the first one, along its axis, of one divided cell.
        if (points_.is_in(cell) != points_.is_in(moved(cell, axis, 1))) close_about(cell, axis);
      }
    }
    return std::move(mesh_);
  }

 private:
  /// A vertex of the ring about an edge, in a cell or on a face.
  struct RingVertex {
    std::uint32_t index = 0;
    Vec3 at = Vec3::Zero();
  };

  void close_about(const GridIndex& corner, std::size_t axis) {
    const std::size_t u = (axis + 1) % 3, w = (axis + 2) % 3;
    const GridIndex before_u = moved(corner, u, -1), before_w = moved(corner, w, -1);
    const GridIndex before_both = moved(before_u, w, -1);
    // Around the axis, right-handed, with the face after each cell.
    const std::array<GridIndex, 4> cells{corner, before_u, before_both, before_w};
    const std::array<std::pair<GridIndex, std::size_t>, 4> faces{
        {{corner, u}, {before_u, w}, {before_w, u}, {corner, w}}};
    std::vector<RingVertex> ring;
    for (std::size_t k = 0; k < 4; ++k) {
      ring.push_back(in_cell(cells[k]));
      const RegionPoints::FacePoint on = points_.on_face(faces[k].first, faces[k].second);
      if (!on.is_straight) ring.push_back(on_face(faces[k].first, faces[k].second, on.at));
    }
    // The ring runs counter-clockwise seen from the end of the edge.
    const bool is_first_in = points_.is_in(corner);
    if (is_first_in == (side_ == MeshOf::rest)) std::ranges::reverse(ring);
    const Vec3 edge = points_.on_edge(corner, axis);
    if (is_flat(ring, edge)) return add_quad(ring);
    const std::uint32_t middle = add(edge);
    for (std::size_t k = 0; k < ring.size(); ++k)
      mesh_.triangles.push_back({middle, ring[k].index, ring[(k + 1) % ring.size()].index});
  }

  static bool is_flat(const std::vector<RingVertex>& ring, const Vec3& edge) {
    if (ring.size() != 4) return false;
    const Vec3 normal = (ring[2].at - ring[0].at).cross(ring[3].at - ring[1].at).normalized();
    return std::ranges::all_of(ring,
                               [&](const RingVertex& v) { return std::abs(normal.dot(v.at - edge)) < kFlat_mm; }) &&
           !diagonals_of(ring, normal).empty();
  }

  /// Returns the diagonals of a plane ring that are inside it, as the index of their first vertex.
  static std::vector<std::size_t> diagonals_of(const std::vector<RingVertex>& ring, const Vec3& normal) {
    const auto is_left = [&](std::size_t a, std::size_t b, std::size_t c) {
      const Vec3 ab = ring[b].at - ring[a].at, ac = ring[c].at - ring[a].at;
      return ab.cross(ac).dot(normal) > kFlat_mm * (ab.norm() + ac.norm());
    };
    std::vector<std::size_t> inside;
    for (const std::size_t k : {0U, 1U})
      if (is_left(k, k + 1, k + 2) && is_left(k, k + 2, (k + 3) % 4)) inside.push_back(k);
    return inside;
  }

  void add_quad(const std::vector<RingVertex>& ring) {
    const Vec3 normal = (ring[2].at - ring[0].at).cross(ring[3].at - ring[1].at).normalized();
    const std::size_t k = diagonals_of(ring, normal).front();
    mesh_.triangles.push_back({ring[k].index, ring[k + 1].index, ring[k + 2].index});
    mesh_.triangles.push_back({ring[k].index, ring[k + 2].index, ring[(k + 3) % 4].index});
  }

  std::uint32_t add(const Vec3& point) {
    mesh_.vertices.push_back(point);
    return static_cast<std::uint32_t>(mesh_.vertices.size() - 1);
  }

  RingVertex in_cell(const GridIndex& cell) {
    const auto [entry, is_new] = cells_.try_emplace(grid_key(cell), 0);
    if (is_new) entry->second = add(points_.in_cell(cell));
    return {entry->second, mesh_.vertices[entry->second]};
  }

  RingVertex on_face(const GridIndex& cell, std::size_t axis, const Vec3& at) {
    const auto [entry, is_new] = faces_[axis].try_emplace(grid_key(cell), 0);
    if (is_new) entry->second = add(at);
    return {entry->second, at};
  }

  const RegionPoints& points_;
  MeshOf side_;
  IndexedMesh mesh_;
  std::unordered_map<std::uint64_t, std::uint32_t, GridHash> cells_;
  std::array<std::unordered_map<std::uint64_t, std::uint32_t, GridHash>, 3> faces_;
};

/// Returns whether every edge has one triangle on each side.
bool is_closed(const IndexedMesh& mesh) {
  std::vector<std::uint64_t> there, back;
  for (const TriangleCorners& triangle : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint64_t a = triangle[k], b = triangle[(k + 1) % 3];
      there.push_back(a << 32U | b);
      back.push_back(b << 32U | a);
    }
  }
  std::ranges::sort(there);
  std::ranges::sort(back);
  return there == back && std::ranges::adjacent_find(there) == there.end();
}

}  // namespace

Result<IndexedMesh> mesh_of(const ProvedRegion& region, MeshOf side) {
  IndexedMesh mesh = MeshMaker(region.points(), side).run(region.divided_cells());
  if (!is_closed(mesh))
    return make_error("stock-mesh-failed",
                      "the mesh of the remaining stock is not closed; this is an error of this program");
  return mesh;
}

}  // namespace gouge

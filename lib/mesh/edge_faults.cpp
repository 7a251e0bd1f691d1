#include "lib/mesh/edge_faults.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>
#include <numeric>
#include <utility>

#include "lib/geom/triangle.h"
#include "lib/mesh/adjacency.h"
#include "lib/mesh/opposite_half_edges.h"
#include "lib/mesh/union_find.h"

namespace gouge {
namespace {

std::array<double, 3> key_of(const Vec3& v) {
  return {v.x() + 0.0, v.y() + 0.0, v.z() + 0.0};  // -0 becomes 0
}

/// Returns the surplus of an edge from its lower vertex to its higher one.
int surplus_of(const MeshAdjacency& adjacency, const MeshEdge& edge) {
  int surplus = 0;
  for (const EdgeUse& use : adjacency.uses(edge)) surplus += use.is_forward ? 1 : -1;
  return surplus;
}

/// Returns the corner of the rim that is farthest from a point.
Vec3 farthest(const IndexedMesh& mesh, const SurfaceGap& gap, const Vec3& slot) {
  Vec3 best = slot;
  for (const FaultyEdge& edge : gap.edges) {
    for (const Corner c : {edge.from, edge.to}) {
      if ((mesh.vertices[c] - slot).squaredNorm() > (best - slot).squaredNorm()) best = mesh.vertices[c];
    }
  }
  return best;
}

void measure(const IndexedMesh& mesh, SurfaceGap& gap) {
  gap.end_a = farthest(mesh, gap, mesh.vertices[gap.edges[0].from]);
  gap.end_b = farthest(mesh, gap, gap.end_a);
  for (const FaultyEdge& edge : gap.edges) {
    for (const Corner c : {edge.from, edge.to})
      gap.width_mm = std::max(gap.width_mm, gap.distance_mm(mesh.vertices[c]));
  }
}

/// Groups `edges` by the connected piece to which they belong, in the order of their lowest vertices.
std::vector<SurfaceGap> gather_gaps(const IndexedMesh& mesh, const std::vector<FaultyEdge>& edges) {
  UnionFind roots(mesh.vertices.size());
  for (const FaultyEdge& edge : edges) roots.join(edge.from, edge.to);
  constexpr std::size_t kNoGap = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> gap_of(mesh.vertices.size(), kNoGap);
  std::vector<SurfaceGap> gaps;
  for (const FaultyEdge& edge : edges) {
    std::size_t& gap = gap_of[roots.root(edge.from)];
    if (gap == kNoGap) {
      gap = gaps.size();
      gaps.emplace_back();
    }
    gaps[gap].edges.push_back(edge);
  }
  for (SurfaceGap& gap : gaps) measure(mesh, gap);
  return gaps;
}

/// Returns the corners, rotated so that the lowest is first.
TriangleCorners turned_to_lowest(TriangleCorners t) {
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

void drop_repeats(WeldedMesh& welded) {
  std::vector<TriangleCorners>& all = welded.mesh.triangles;
  std::vector<std::uint32_t> order(all.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::pair(turned_to_lowest(all[a]), a) < std::pair(turned_to_lowest(all[b]), b);
  });
  std::vector<bool> is_repeat(all.size(), false);
  for (std::size_t i = 1; i < order.size(); ++i)
    is_repeat[order[i]] = turned_to_lowest(all[order[i]]) == turned_to_lowest(all[order[i - 1]]);
  std::size_t kept = 0;
  for (std::size_t t = 0; t < all.size(); ++t) {
    if (is_repeat[t]) continue;
    all[kept] = all[t];
    welded.file_of[kept++] = welded.file_of[t];
  }
  welded.repeated = all.size() - kept;
  all.resize(kept);
  welded.file_of.resize(kept);
}

}  // namespace

double SurfaceGap::distance_mm(const Vec3& point) const { return distance_to_segment(point, end_a, end_b); }

WeldedMesh weld_together(std::span<const IndexedMesh> meshes) {
  WeldedMesh result;
  IndexedMesh& welded = result.mesh;
  for (const IndexedMesh& mesh : meshes)
    welded.vertices.insert(welded.vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
  std::vector<Corner> order(welded.vertices.size());
  std::iota(order.begin(), order.end(), Corner{0});
  std::sort(order.begin(), order.end(), [&](Corner a, Corner b) {
    const auto ka = key_of(welded.vertices[a]), kb = key_of(welded.vertices[b]);
    return ka != kb ? ka < kb : a < b;
  });
  std::vector<Corner> slot(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool is_same = i > 0 && key_of(welded.vertices[order[i]]) == key_of(welded.vertices[order[i - 1]]);
    slot[order[i]] = is_same ? slot[order[i - 1]] : order[i];
  }
  Corner first = 0;
  for (std::size_t file = 0; file < meshes.size(); ++file) {
    for (const TriangleCorners& t : meshes[file].triangles) {
      welded.triangles.push_back({slot[first + t[0]], slot[first + t[1]], slot[first + t[2]]});
      result.file_of.push_back(static_cast<std::uint32_t>(file));
    }
    first += static_cast<Corner>(meshes[file].vertices.size());
  }
  drop_repeats(result);
  return result;
}

EdgeFaults find_edge_faults(const IndexedMesh& mesh) {
  EdgeFaults faults;
  if (find_opposite_half_edges(mesh)) return faults;
  const MeshAdjacency adjacency(mesh);
  std::vector<FaultyEdge> edges;
  for (const MeshEdge& edge : adjacency.edges()) {
    const int surplus = surplus_of(adjacency, edge);
    if (surplus == 0) continue;
    ++(edge.use_count % 2 != 0 ? faults.open : faults.misoriented);
    edges.push_back(surplus > 0 ? FaultyEdge{edge.low, edge.high, surplus} : FaultyEdge{edge.high, edge.low, -surplus});
  }
  faults.gaps = gather_gaps(mesh, edges);
  return faults;
}

}  // namespace gouge

#include "lib/mesh/adjacency.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace gouge {
namespace {

// A triangle's side, kept in the bucket of its lower vertex.
struct Side {
  Corner high = 0;
  std::uint32_t triangle = 0;
  std::uint8_t k = 0;
  bool is_forward = true;
};

bool operator<(const Side& a, const Side& b) {
  return std::tie(a.high, a.triangle, a.k) < std::tie(b.high, b.triangle, b.k);
}

// Turns counts (stored one place later) into the first index of each bucket.
void counts_to_firsts(std::vector<std::uint32_t>& counts) {
  std::partial_sum(counts.begin(), counts.end(), counts.begin());
}

}  // namespace

MeshAdjacency::MeshAdjacency(const IndexedMesh& mesh) {
  collect_triangles_of_vertices(mesh);
  collect_edges(mesh);
  for (std::uint32_t i = 0; i < edges_.size(); ++i) {
    if (edges_[i].use_count == 1) boundary_edges_.push_back(i);
    if (edges_[i].use_count > 2) non_manifold_edges_.push_back(i);
  }
}

void MeshAdjacency::collect_triangles_of_vertices(const IndexedMesh& mesh) {
  vertex_first_.assign(mesh.vertices.size() + 1, 0);
  for (const TriangleCorners& corners : mesh.triangles) {
    for (const Corner c : corners) ++vertex_first_[c + 1];
  }
  counts_to_firsts(vertex_first_);
  vertex_triangles_.resize(3 * mesh.triangles.size());
  std::vector<std::uint32_t> next(vertex_first_.begin(), vertex_first_.end() - 1);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const Corner c : mesh.triangles[t]) vertex_triangles_[next[c]++] = t;
  }
}

void MeshAdjacency::collect_edges(const IndexedMesh& mesh) {
  const auto side = [&](std::uint32_t t, std::uint8_t k) {
    return std::pair(mesh.triangles[t][k], mesh.triangles[t][(k + 1U) % 3U]);
  };
  const std::size_t triangle_count = mesh.triangles.size();
  std::vector<std::uint32_t> first(mesh.vertices.size() + 1, 0);
  for (std::uint32_t t = 0; t < triangle_count; ++t) {
    for (std::uint8_t k = 0; k < 3; ++k) ++first[std::min(side(t, k).first, side(t, k).second) + 1];
  }
  counts_to_firsts(first);
  std::vector<Side> sides(3 * triangle_count);
  std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
  for (std::uint32_t t = 0; t < triangle_count; ++t) {
    for (std::uint8_t k = 0; k < 3; ++k) {
      const auto [from, to] = side(t, k);
      sides[next[std::min(from, to)]++] = {std::max(from, to), t, k, from < to};
    }
  }
  uses_.resize(sides.size());
  triangle_edges_.resize(triangle_count);
  edges_.reserve(sides.size() / 2 + 1);
  for (Corner low = 0; low < mesh.vertices.size(); ++low) {
    std::sort(sides.begin() + first[low], sides.begin() + first[low + 1]);
    for (std::uint32_t i = first[low]; i < first[low + 1]; ++i) {
      if (i == first[low] || sides[i].high != sides[i - 1].high) edges_.push_back({low, sides[i].high, i, 0});
      ++edges_.back().use_count;
      uses_[i] = {sides[i].triangle, sides[i].is_forward};
      triangle_edges_[sides[i].triangle][sides[i].k] = static_cast<std::uint32_t>(edges_.size() - 1);
    }
  }
}

}  // namespace gouge

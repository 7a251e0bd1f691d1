#include "lib/mesh/adjacency.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace gouge {

MeshAdjacency::MeshAdjacency(const IndexedMesh& mesh) : around_(mesh) {
  const std::size_t triangle_count = mesh.triangles.size();
  const auto from = [&](std::size_t t, std::size_t k) { return mesh.triangles[t][k]; };
  const auto to = [&](std::size_t t, std::size_t k) { return mesh.triangles[t][(k + 1) % 3]; };
  // Lists the sides 3 t + k in buckets, one for each lower vertex. A bucket begins where the one before it ends.
  std::vector<std::uint32_t> end(mesh.vertices.size() + 1, 0);
  for (std::size_t t = 0; t < triangle_count; ++t) {
    for (std::size_t k = 0; k < 3; ++k) ++end[std::min(from(t, k), to(t, k)) + 1];
  }
  std::partial_sum(end.begin(), end.end(), end.begin());
  std::vector<std::uint32_t> sides(3 * triangle_count);
  for (std::size_t t = 0; t < triangle_count; ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      sides[end[std::min(from(t, k), to(t, k))]++] = static_cast<std::uint32_t>(3 * t + k);
    }
  }
  uses_.reserve(sides.size());
  triangle_edges_.resize(triangle_count);
  edges_.reserve(sides.size() / 2 + 1);
  std::vector<std::pair<Corner, std::uint32_t>> bucket;  // the higher vertex, and the side
  for (Corner low = 0; low < mesh.vertices.size(); ++low) {
    bucket.clear();
    for (std::size_t i = uses_.size(); i < end[low]; ++i) {
      const std::size_t t = sides[i] / 3, k = sides[i] % 3;
      bucket.emplace_back(std::max(from(t, k), to(t, k)), sides[i]);
    }
    std::sort(bucket.begin(), bucket.end());
    for (std::size_t i = 0; i < bucket.size(); ++i) {
      const auto [high, side] = bucket[i];
      if (i == 0 || high != bucket[i - 1].first) {
        edges_.push_back({low, high, static_cast<std::uint32_t>(uses_.size()), 0});
      }
      ++edges_.back().use_count;
      uses_.push_back({side / 3, from(side / 3, side % 3) == low});
      triangle_edges_[side / 3][side % 3] = static_cast<std::uint32_t>(edges_.size() - 1);
    }
  }
}

}  // namespace gouge

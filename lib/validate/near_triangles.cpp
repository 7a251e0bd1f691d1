#include "lib/validate/near_triangles.h"

#include <algorithm>
#include <numeric>

#include "lib/base/large_pages.h"
#include "lib/base/parallel.h"
#include "lib/mesh/indexed_mesh.h"

namespace gouge::detail {
namespace {

constexpr std::size_t kPartLeaves = 64;
constexpr std::size_t kSortedWhole = 4096;  // number of leaves up to which one thread sorts a range

}  // namespace

std::vector<std::uint32_t> all_triangles(const IndexedMesh& mesh) {
  std::vector<std::uint32_t> all(mesh.triangles.size());
  std::iota(all.begin(), all.end(), 0U);
  return all;
}

NearTriangles::NearTriangles(const IndexedMesh& mesh, const std::vector<std::uint32_t>& triangles) {
  if (triangles.empty()) return;
  const std::size_t leaves = (triangles.size() + kLanes - 1) / kLanes;
  const Range all{0, 0, leaves};
  {
    std::vector<Centre> centres;
    reserve_large(centres, triangles.size());
    for (const std::uint32_t t : triangles) {
      const Vec3 at = box_of(mesh, t).center();
      centres.push_back({{at.x(), at.y(), at.z()}, t});
    }
    sort(centres, all);
    reserve_large(leaves_, leaves);
    leaves_.resize(leaves);
    for_each_chunk(leaves, 1 << 12, 0, [&](std::size_t from, std::size_t to) {
      for (std::size_t leaf = from; leaf < to; ++leaf) fill(mesh, centres, leaf);
    });
  }
  boxes_.resize(2 * leaves - 1);
  bound(all);
  cut(all);
}

// Sorts ranges in parallel as soon as there are many.
void NearTriangles::sort(std::vector<Centre>& centres, const Range& all) {
  std::vector<Range> small, large{all};
  while (!large.empty()) {
    const Range range = large.back();
    large.pop_back();
    if (range.size() <= kSortedWhole) {
      small.push_back(range);
      continue;
    }
    halve(centres, range);
    large.push_back(range.left());
    large.push_back(range.right());
  }
  for_each_chunk(small.size(), 1, 0, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) sort_whole(centres, small[k]);
  });
}

void NearTriangles::sort_whole(std::vector<Centre>& centres, const Range& range) {
  if (range.size() < 2) return;
  halve(centres, range);
  sort_whole(centres, range.left());
  sort_whole(centres, range.right());
}

// Divides at the median along the longest side of the box of the centres.
void NearTriangles::halve(std::vector<Centre>& centres, const Range& range) {
  const auto first = centres.begin() + static_cast<std::ptrdiff_t>(range.first * kLanes);
  const auto middle = centres.begin() + static_cast<std::ptrdiff_t>(range.middle() * kLanes);
  const auto last = centres.begin() + static_cast<std::ptrdiff_t>(std::min(range.last * kLanes, centres.size()));
  std::array<double, 3> low = first->at, high = low;
  for (auto it = first; it != last; ++it) {
    for (std::size_t k = 0; k < 3; ++k) low[k] = std::min(low[k], it->at[k]), high[k] = std::max(high[k], it->at[k]);
  }
  std::size_t axis = 0;
  for (std::size_t k = 1; k < 3; ++k) {
    if (high[k] - low[k] > high[axis] - low[axis]) axis = k;
  }
  std::nth_element(first, middle, last, [axis](const Centre& a, const Centre& b) { return a.at[axis] < b.at[axis]; });
}

void NearTriangles::fill(const IndexedMesh& mesh, const std::vector<Centre>& centres, std::size_t leaf) {
  Leaf& filled = leaves_[leaf];
  const std::size_t first = leaf * kLanes;
  filled.count = std::min(kLanes, centres.size() - first);
  for (std::size_t i = 0; i < filled.count; ++i) {
    filled.triangle[i] = centres[first + i].triangle;
    const Box3 box = box_of(mesh, filled.triangle[i]);
    for (std::size_t k = 0; k < 3; ++k) {
      filled.low[k][i] = box.min()[static_cast<Eigen::Index>(k)];
      filled.high[k][i] = box.max()[static_cast<Eigen::Index>(k)];
    }
  }
}

Box3 NearTriangles::bound(const Range& range) {
  Box3& box = boxes_[range.node];
  if (range.size() > 1) {
    box = bound(range.left()).merged(bound(range.right()));
    return box;
  }
  const Leaf& leaf = leaves_[range.first];
  for (std::size_t i = 0; i < leaf.count; ++i) {
    box.extend(Vec3(leaf.low[0][i], leaf.low[1][i], leaf.low[2][i]));
    box.extend(Vec3(leaf.high[0][i], leaf.high[1][i], leaf.high[2][i]));
  }
  return box;
}

void NearTriangles::cut(const Range& range) {
  if (range.size() <= kPartLeaves) {
    parts_.push_back(range);
    return;
  }
  cut(range.left());
  cut(range.right());
}

}  // namespace gouge::detail

#include "lib/validate/self_intersections.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <utility>

#include "lib/base/parallel.h"
#include "lib/validate/cgal_bridge.h"
#include "lib/validate/near_triangles.h"
#include "lib/validate/triangle_filter.h"

namespace gouge::detail {
namespace {

constexpr std::size_t kPartsAtOnce = 64;

std::array<Vec3, 3> points(const IndexedMesh& mesh, const TriangleCorners& t) {
  return {mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
}

/// The corners of two triangles. The shared corners are first and in the same order.
struct Aligned {
  Aligned(const TriangleCorners& t, const TriangleCorners& u) : one(t), other(u) {
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = shared; j < 3; ++j) {
        if (one[i] != other[j]) continue;
        std::swap(one[i], one[shared]);
        std::swap(other[j], other[shared]);
        ++shared;
        break;
      }
    }
  }

  TriangleCorners one, other;
  std::size_t shared = 0;
};

bool is_surely_clear(const IndexedMesh& mesh, const TrianglePair& pair) {
  const Aligned corners(mesh.triangles[pair.first], mesh.triangles[pair.second]);
  const auto one = points(mesh, corners.one), other = points(mesh, corners.other);
  switch (corners.shared) {
    case 0:
      return are_surely_apart(one, other);
    case 1:
      return share_surely_one_corner(one, other);
    case 2:
      return share_surely_one_side(one, other);
    default:
      return true;  // a copy is not an intersection
  }
}

// Returns, in increasing order, the first triangle of each set of triangles with the same corners.
std::vector<std::uint32_t> originals(const IndexedMesh& mesh) {
  std::vector<std::pair<TriangleCorners, std::uint32_t>> sorted;
  sorted.reserve(mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    TriangleCorners corners = mesh.triangles[t];
    std::sort(corners.begin(), corners.end());
    sorted.emplace_back(corners, t);
  }
  std::sort(sorted.begin(), sorted.end());
  const auto last =
      std::unique(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.first == b.first; });
  std::vector<std::uint32_t> first;
  for (auto it = sorted.begin(); it != last; ++it) first.push_back(it->second);
  std::sort(first.begin(), first.end());
  return first;
}

std::vector<std::uint32_t> without(const std::vector<std::uint32_t>& all, const std::vector<std::uint32_t>& some) {
  std::vector<std::uint32_t> left;
  left.reserve(all.size());
  std::set_difference(all.begin(), all.end(), some.begin(), some.end(), std::back_inserter(left));
  return left;
}

/// Returns the pairs in parts [first, last) that may cross, in the order of the parts.
std::vector<TrianglePair> doubtful_pairs(const IndexedMesh& mesh, const NearTriangles& near, std::size_t first,
                                         std::size_t last) {
  std::vector<std::vector<TrianglePair>> found(last - first);
  for_each_chunk(found.size(), 1, 0, [&](std::size_t from, std::size_t to) {
    for (std::size_t k = from; k < to; ++k) {
      near.for_each_pair(first + k, [&](std::uint32_t t, std::uint32_t u) {
        const TrianglePair pair = std::minmax(t, u);
        if (!is_surely_clear(mesh, pair)) found[k].push_back(pair);
      });
    }
  });
  std::vector<TrianglePair> all;
  for (const std::vector<TrianglePair>& part : found) all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace

Result<std::vector<std::uint32_t>> find_triangles_without_area(const IndexedMesh& mesh) {
  std::vector<std::uint32_t> doubtful;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!surely_has_area(points(mesh, mesh.triangles[t]))) doubtful.push_back(t);
  }
  if (doubtful.empty()) return doubtful;
  return without_area(mesh, doubtful);
}

Result<SelfIntersections> find_self_intersections(const IndexedMesh& mesh,
                                                  const std::vector<std::uint32_t>& without_area, bool has_copies,
                                                  const ProgressCall& progress) {
  const NearTriangles near(mesh, without(has_copies ? originals(mesh) : all_triangles(mesh), without_area));
  SelfIntersections found;
  TrianglePair first;
  for (std::size_t part = 0; part < near.parts(); part += kPartsAtOnce) {
    if (progress) progress("finding self-intersections", part, near.parts());
    const std::vector<TrianglePair> doubtful =
        doubtful_pairs(mesh, near, part, std::min(near.parts(), part + kPartsAtOnce));
    if (doubtful.empty()) continue;
    const Result<std::vector<TrianglePair>> crossing = crossing_pairs(mesh, doubtful);
    if (!crossing) return crossing.error();
    for (const TrianglePair& pair : *crossing) {
      if (found.pairs++ == 0 || pair < first) first = pair;
    }
  }
  if (found.pairs == 0) return found;
  const Result<Vec3> place = meeting_point(mesh, first);
  if (!place) return place.error();
  found.first_triangle = mesh.file_triangle[first.first];
  found.second_triangle = mesh.file_triangle[first.second];
  found.position_mm = *place;
  return found;
}

}  // namespace gouge::detail

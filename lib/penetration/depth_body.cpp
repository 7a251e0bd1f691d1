#include "lib/penetration/depth_body.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lib/penetration/below_facets.h"
#include "lib/penetration/inner_reach.h"

namespace gouge {
namespace {

/// Fills body.boxes from its tree and corners.
/// Cost  O(n).
void fill_node_boxes(DepthBody& body) {
  body.boxes.resize(6 * body.tree.nodes.size());
  for (std::size_t n = body.tree.nodes.size(); n-- > 0;) {
    const KdopNode& node = body.tree.nodes[n];
    float* const box = body.boxes.data() + 6 * n;
    Box3 all;
    for (std::uint32_t k = 0; node.children == 0 && k < node.item_count; ++k) {
      for (const Vec3& corner : body.corners[node.first + k]) all.extend(corner);
    }
    for (int i = 0; i < 3; ++i) {
      if (node.children == 0) {
        box[i] = static_cast<float>(all.min()[i]) - body.slack_mm;
        box[i + 3] = static_cast<float>(all.max()[i]) + body.slack_mm;
        continue;
      }
      const float* const first = body.boxes.data() + 6 * std::size_t{node.first};
      box[i] = first[i];
      box[i + 3] = first[i + 3];
      for (std::size_t k = 1; k < node.children; ++k) {
        box[i] = std::min(box[i], first[6 * k + static_cast<std::size_t>(i)]);
        box[i + 3] = std::max(box[i + 3], first[6 * k + static_cast<std::size_t>(i) + 3]);
      }
    }
  }
}

// A coordinate of size s is off by 2^-24 s in single precision, a projection of three by less than four times
// that.
constexpr double kBodySingle = 4.0 / (1 << 24);

double largest_coordinate(const IndexedMesh& mesh) {
  double largest = 0;
  for (const Vec3& v : mesh.vertices) largest = std::max(largest, v.cwiseAbs().maxCoeff());
  return largest;
}

/// Intervals of a facet, its offset facet, and with complete coverage of all within the depth.
class FacetBounds {
 public:
  FacetBounds(const DepthBody& body, const InnerReach& reach, double slack)
      : body_(body), reach_(reach), slack_(slack) {}

  void operator()(std::uint32_t triangle, float* intervals) {
    const DepthBodyOptions& options = body_.options;
    const std::array<Vec3, 3> facet = body_.surface.corners(triangle);
    std::array<Vec3, 6> both;
    for (std::size_t k = 0; k < 3; ++k) {
      both[k] = facet[k];
      both[k + 3] = facet[k] - options.depth_mm * body_.offsets[body_.mesh().triangles[triangle][k]].move;
    }
    write_intervals(options.directions, both, slack_, intervals);
    if (options.coverage == Coverage::offset) return;
    for (std::size_t i = 0; i < options.directions.axes.size(); ++i) {
      const Vec3& u = options.directions.axes[i];
      const double high = reach_.above(triangle, u, options.depth_mm) + slack_;
      const double low = -reach_.above(triangle, -u, options.depth_mm) - slack_;
      intervals[low_slot(i)] = std::min(intervals[low_slot(i)], static_cast<float>(low));
      intervals[high_slot(i)] = std::max(intervals[high_slot(i)], static_cast<float>(high));
    }
  }

 private:
  const DepthBody& body_;
  const InnerReach& reach_;
  double slack_;
};

FacetRecord record_of(const std::array<Vec3, 3>& facet, const Vec3& normal) {
  const Vec3 centre = (facet[0] + facet[1] + facet[2]) / 3.0;
  double radius = 0;
  for (const Vec3& corner : facet) radius = std::max(radius, (corner - centre).norm());
  FacetRecord record{};
  for (int i = 0; i < 3; ++i) {
    record.n[i] = static_cast<float>(normal[i]);
    record.c[i] = static_cast<float>(centre[i]);
  }
  record.o = static_cast<float>(normal.dot(facet[0]));
  record.r = static_cast<float>(radius);
  return record;
}

}  // namespace

DepthBody build_depth_body(Surface surface, const DepthBodyOptions& options) {
  const IndexedMesh& mesh = surface.mesh();
  const MeshAdjacency adjacency(mesh);
  DepthBody body{std::move(surface), options, options.offset_vertices(mesh, adjacency), {}, {}, {}, {}, {}, {}};
  const double reach = largest_coordinate(mesh) + (1 + kLongestOffset) * options.depth_mm;
  body.slack_mm = static_cast<float>(kBodySingle * reach);
  std::vector<Vec3> centres;
  centres.reserve(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::array<Vec3, 3> facet = body.surface.corners(t);
    centres.emplace_back((facet[0] + facet[1] + facet[2]) / 3.0);
  }
  const std::vector<Vec3> normals = face_normals(mesh);
  const InnerReach inner(mesh, adjacency, normals);
  FacetBounds bounds(body, inner, kBodySingle * reach);
  body.tree = build_kdop_tree(options.directions, centres, {options.width, options.leaf_triangles},
                              [&bounds](std::uint32_t t, float* intervals) { bounds(t, intervals); });
  for (const std::uint32_t t : body.tree.order) {
    body.corners.push_back(body.surface.corners(t));
    body.facets.push_back(record_of(body.corners.back(), normals[t]));
  }
  fill_node_boxes(body);
  body.is_clear_below = facets_clear_below(body);
  if (body.is_solid()) body.depths = DepthGrid(body);
  return body;
}

}  // namespace gouge

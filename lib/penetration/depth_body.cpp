#include "lib/penetration/depth_body.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "lib/base/tolerance.h"
#include "lib/geom/vec.h"
#include "lib/mesh/adjacency.h"
#include "lib/mesh/indexed_mesh.h"
#include "lib/offset/vertex_offsets.h"
#include "lib/penetration/narrow_phase.h"

namespace gouge {
namespace {

/// The reach of the inside points that are nearest to a facet. A volume must contain them so that no point within the
/// depth is missed. They lie below the face, in the wedge at a reflex edge, or in the cone at a vertex that is not
/// convex.
/// Proof: docs/method/shallow_penetration.md, section 4.
class InnerReach {
 public:
  InnerReach(const IndexedMesh& mesh, const MeshAdjacency& adjacency, const std::vector<Vec3>& face_normals);

  /// Returns an upper bound of u . x over the inside points x that are nearest to `triangle` and within `depth_mm` of
  /// it, and over the facet itself. u is a unit vector.
  [[nodiscard]] double above(std::uint32_t triangle, const Vec3& u, double depth_mm) const;

 private:
  /// The directions from a vertex to the inside points nearest to it: within an angle of `axis`.
  struct Cone {
    Vec3 axis = Vec3::Zero();
    double cosine = 2;  ///< above 1: there are none; -1: all directions
  };

  [[nodiscard]] Cone cone_at(Corner vertex, const MeshAdjacency& adjacency) const;
  void find_wedges(const MeshAdjacency& adjacency);

  const IndexedMesh& mesh_;
  const std::vector<Vec3>& normals_;
  std::vector<Cone> cones_;                  ///< by vertex
  std::vector<std::array<Cone, 3>> wedges_;  ///< by triangle and edge
};

// Length by which a ray may violate a constraint and still belong to the cone: a wider cone is safe.
constexpr double kFeasible = 1e-7;
constexpr double kNoPlane = 1e-13;
// Maximum number of constraints for which rays are computed; more would cost too much time. With more, the cone is all
// directions below the vertex.
constexpr std::size_t kManyEdges = 40;

InnerReach::InnerReach(const IndexedMesh& mesh, const MeshAdjacency& adjacency, const std::vector<Vec3>& face_normals)
    : mesh_(mesh), normals_(face_normals) {
  cones_.reserve(mesh.vertices.size());
  for (Corner v = 0; v < mesh.vertices.size(); ++v) cones_.push_back(cone_at(v, adjacency));
  find_wedges(adjacency);
}

/// Returns the cone of points nearest to a vertex. For such a point every edge at the vertex leads away from it. The
/// extreme rays, which are crossings of two constraint planes, bound the cone.
InnerReach::Cone InnerReach::cone_at(Corner vertex, const MeshAdjacency& adjacency) const {
  const Vec3 outward = angle_weighted_normal(mesh_, adjacency, normals_, vertex);
  if (outward.squaredNorm() < 0.5) return {Vec3::UnitZ(), -1};
  std::vector<Vec3> constraints = {outward};
  for (const std::uint32_t t : adjacency.triangles_of_vertex(vertex)) {
    for (const Corner c : mesh_.triangles[t]) {
      const Vec3 edge = mesh_.vertices[c] - mesh_.vertices[vertex];
      const double length = edge.norm();
      if (c == vertex || !(length > 0)) continue;
      const Vec3 unit = edge / length;
      const bool is_known = std::any_of(constraints.begin(), constraints.end(),
                                        [&](const Vec3& k) { return (k - unit).cwiseAbs().maxCoeff() <= 0; });
      if (!is_known) constraints.push_back(unit);
    }
  }
  if (constraints.size() > kManyEdges) return {-outward, 0};
  Cone cone{-outward, 2};
  for (std::size_t i = 0; i < constraints.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Vec3 across = constraints[i].cross(constraints[j]);
      if (across.norm() < kNoPlane) continue;
      for (const double sign : {1.0, -1.0}) {
        const Vec3 ray = sign * across.normalized();
        const bool is_feasible =
            std::all_of(constraints.begin(), constraints.end(), [&](const Vec3& k) { return k.dot(ray) <= kFeasible; });
        if (is_feasible) cone.cosine = std::min(cone.cosine, cone.axis.dot(ray));
      }
    }
  }
  return cone;
}

void InnerReach::find_wedges(const MeshAdjacency& adjacency) {
  wedges_.resize(mesh_.triangles.size());
  for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      Cone& wedge = wedges_[t][k];
      const auto uses = adjacency.uses(adjacency.edges()[adjacency.edges_of_triangle(t)[k]]);
      const bool is_plain = uses.size() == 2 && uses[0].is_forward != uses[1].is_forward;
      const std::uint32_t other = is_plain ? (uses[0].triangle == t ? uses[1].triangle : uses[0].triangle) : t;
      const Vec3 sum = normals_[t] + normals_[other];
      const bool has_areas = normals_[t].squaredNorm() > 0 && normals_[other].squaredNorm() > 0;
      if (!is_plain || !has_areas || sum.norm() < Tolerance::kNoSide) {
        wedge = {Vec3::UnitZ(), -1};
        continue;
      }
      const Vec3 along = mesh_.corner(t, (k + 1) % 3) - mesh_.corner(t, k);
      const bool is_convex = normals_[t].cross(normals_[other]).dot(along) > 0;
      if (!is_convex) wedge = {-sum.normalized(), 0.5 * sum.norm()};
    }
  }
}

double InnerReach::above(std::uint32_t triangle, const Vec3& u, double depth_mm) const {
  const auto reach = [&](const Cone& cone) {
    if (cone.cosine > 1) return 0.0;
    const double cosine = u.dot(cone.axis);
    if (cosine >= cone.cosine) return 1.0;
    const double turn = std::sqrt(std::max(0.0, 1 - cone.cosine * cone.cosine));
    const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
    return std::max(0.0, cosine * cone.cosine + sine * turn);
  };
  const std::array<Vec3, 3> facet = {mesh_.corner(triangle, 0), mesh_.corner(triangle, 1), mesh_.corner(triangle, 2)};
  std::array<double, 3> at{};
  for (std::size_t k = 0; k < 3; ++k) at[k] = u.dot(facet[k]);
  const double below = normals_[triangle].squaredNorm() > 0 ? std::max(0.0, -u.dot(normals_[triangle])) : 1.0;
  double most = *std::max_element(at.begin(), at.end()) + depth_mm * below;
  for (std::size_t k = 0; k < 3; ++k) {
    most = std::max(most, at[k] + depth_mm * reach(cones_[mesh_.triangles[triangle][k]]));
    most = std::max(most, std::max(at[k], at[(k + 1) % 3]) + depth_mm * reach(wedges_[triangle][k]));
  }
  return most;
}

/// Fills body.boxes from the tree and the corners.
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

// Relative rounding of a projection in single precision. A coordinate of size s is off by 2^-24 s, and a projection of
// three by less than four times that.
constexpr double kBodySingle = 4.0 / (1 << 24);

double largest_coordinate(const IndexedMesh& mesh) {
  double largest = 0;
  for (const Vec3& v : mesh.vertices) largest = std::max(largest, v.cwiseAbs().maxCoeff());
  return largest;
}

/// The intervals of a facet and its offset facet; with complete coverage, of all points within the depth.
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

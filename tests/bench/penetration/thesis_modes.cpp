#include "tests/bench/penetration/thesis_modes.h"

#include "lib/mesh/adjacency.h"

namespace gouge {
namespace {

// Returns whether the projections `p` of a point, one for each axis, lie in every interval.
bool does_hold(const float* volume, const float* p, std::size_t stride) {
  for (std::size_t i = 0; i < stride; i += 4) {
    const Float4 at = load4(p + i);
    if (any4((load4(volume + 2 * i) > at) | (at > load4(volume + 2 * i + 4)))) return false;
  }
  return true;
}

/// Spanned by the edge and the sum of both normals (the rhombus diagonal), which unlike their difference also
/// represents coplanar neighbours. Neighbours folded back on each other share the facet's own rim.
BisectorNormals bisectors_of(const DepthBody& body, const MeshAdjacency& adjacency, std::uint32_t triangle) {
  BisectorNormals normals;
  const std::array<Vec3, 3> facet = {body.mesh().corner(triangle, 0), body.mesh().corner(triangle, 1),
                                     body.mesh().corner(triangle, 2)};
  const Vec3 own = body.surface.face_normal(triangle);
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 along = facet[(k + 1) % 3] - facet[k];
    Vec3 sum = own;
    for (const EdgeUse& use : adjacency.uses(adjacency.edges()[adjacency.edges_of_triangle(triangle)[k]])) {
      if (use.triangle != triangle) sum += body.surface.face_normal(use.triangle);
    }
    const Vec3 across = sum.cross(along);
    normals[k] = across.norm() > 1e-9 * along.norm() ? Vec3(across.normalized()) : Vec3(own.cross(along));
  }
  return normals;
}

}  // namespace

ThesisModes::ThesisModes(const DepthBody& body) : body_(body), leaves_(body.corners.size()) {
  const MeshAdjacency adjacency(body.mesh());
  for (const std::uint32_t triangle : body.tree.order) bisectors_.push_back(bisectors_of(body, adjacency, triangle));
  for (std::uint32_t n = 0; n < body.tree.nodes.size(); ++n) {
    const KdopNode& node = body.tree.nodes[n];
    for (std::uint32_t k = 0; node.children == 0 && k < node.item_count; ++k) leaves_[node.first + k] = n;
  }
}

std::optional<double> ThesisModes::depth_mm(const Vec3& point, ThesisMode mode) const {
  const KdopTree& tree = body_.tree;
  std::vector<float> projections(tree.stride, 0.0F);
  for (std::size_t i = 0; i < tree.directions.axes.size(); ++i)
    projections[i] = static_cast<float>(tree.directions.axes[i].dot(point));
  std::optional<double> least;
  for (std::size_t place = 0; place < body_.corners.size(); ++place) {
    const double depth = -body_.surface.face_normal(tree.order[place]).dot(point - body_.corners[place][0]);
    if (depth < 0 || depth > body_.options.depth_mm || (least && depth >= *least)) continue;
    const bool is_own = mode == ThesisMode::planes
                            ? is_within_bisectors(point, place)
                            : does_hold(tree.bounds_of(leaves_[place]), projections.data(), tree.stride);
    if (is_own) least = depth;
  }
  return least;
}

bool ThesisModes::is_within_bisectors(const Vec3& point, std::size_t place) const {
  for (std::size_t k = 0; k < 3; ++k) {
    const double side = bisectors_[place][k].dot(point - body_.corners[place][k]);
    if (side < -static_cast<double>(body_.slack_mm)) return false;
  }
  return true;
}

}  // namespace gouge

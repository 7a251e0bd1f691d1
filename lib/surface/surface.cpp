#include "lib/surface/surface.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <limits>
#include <mutex>
#include <optional>
#include <utility>

#include "lib/base/tolerance.h"
#include "lib/hierarchy/block_tree.h"
#include "lib/hierarchy/closest_triangle.h"
#include "lib/hierarchy/lane_bound.h"
#include "lib/mesh/mesh_findings.h"
#include "lib/mesh/opposite_half_edges.h"
#include "lib/mesh/ray_cone.h"
#include "lib/surface/solid_boundary.h"
#include "lib/surface/surface_sign.h"

namespace gouge {
namespace {

class RayWalk {
 public:
  RayWalk(const BlockTree& tree, const Vec3& point, const Vec3& direction)
      : tree_(tree), point_(point), direction_(direction) {
    const Vec3 first = direction.unitOrthogonal();
    const std::array<Vec3, 2> beside = {first, direction.cross(first)};
    const Vec3 local = point - tree.origin;
    for (std::size_t a = 0; a < 2; ++a) {
      for (std::size_t k = 0; k < 3; ++k) beside_[a][k] = static_cast<float>(beside[a][static_cast<Eigen::Index>(k)]);
      at_[a] = static_cast<float>(beside[a].dot(local));
    }
    // Bound on the rounding of coordinates and sums in single precision.
    off_mm_ = static_cast<float>(Tolerance::kRounding_mm + 2 * tree.rounding_mm +
                                 Tolerance::kSingleSum * (tree.radius_mm + local.norm()));
  }

  std::optional<int> run() {
    if (!tree_.nodes.empty() && !visit(0)) return std::nullopt;
    return winding_;
  }

 private:
  /// Visits a node. Returns false as soon as a crossing is doubtful.
  bool visit(std::uint32_t index) {
    const NodeBlock& node = tree_.nodes[index];
    for (std::uint32_t i = 0; i < node.count; ++i) {
      const LaneBound lane(tree_, node, i);
      const Vec3 from = lane.center - point_;
      const double along = from.dot(direction_), reach = lane.radius_mm + Tolerance::kRounding_mm;
      if (along < -reach || from.squaredNorm() - along * along > reach * reach) continue;
      if (!(node.has_leaves ? visit_leaf(node.child[i]) : visit(node.child[i]))) return false;
    }
    return true;
  }

  /// Returns the triangles that the line through the ray may cross, judged by two axes beside it.
  [[nodiscard]] std::uint32_t near_lanes(const TriangleBlock& leaf) const {
    std::array<std::uint8_t, kBlockLanes> is_near;
    is_near.fill(1);
    for (std::size_t a = 0; a < 2; ++a) {
      const auto& along = beside_[a];
      for (std::size_t i = 0; i < kBlockLanes; ++i) {
        float low = std::numeric_limits<float>::max(), high = -low;
        for (const auto& corner : leaf.corner) {
          const float at = along[0] * corner[0][i] + along[1] * corner[1][i] + along[2] * corner[2][i] - at_[a];
          low = std::min(low, at);
          high = std::max(high, at);
        }
        is_near[i] = static_cast<std::uint8_t>(is_near[i] & static_cast<std::uint8_t>(low <= off_mm_) &
                                               static_cast<std::uint8_t>(high >= -off_mm_));
      }
    }
    std::uint32_t mask = 0;
    for (std::uint32_t i = 0; i < leaf.count; ++i) mask |= static_cast<std::uint32_t>(is_near[i]) << i;
    return mask;
  }

  bool visit_leaf(std::uint32_t index) {
    const TriangleBlock& leaf = tree_.leaves[index];
    for (std::uint32_t lanes = near_lanes(leaf); lanes != 0; lanes &= lanes - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(lanes));
      const RayCrossing crossing = RayCone(tree_.corners(leaf.triangle[i]), point_).crossing(direction_);
      if (crossing == RayCrossing::doubtful) return false;
      if (crossing != RayCrossing::none) winding_ += crossing == RayCrossing::out ? 1 : -1;
    }
    return true;
  }

  const BlockTree& tree_;
  Vec3 point_, direction_;
  std::array<std::array<float, 3>, 2> beside_{};  // two axes square to the ray, ...
  std::array<float, 2> at_{};                     // ... and the ray's positions on them, in the tree's frame
  float off_mm_ = 0;
  int winding_ = 0;
};

// Returns how often closed surfaces wind around a point: the number of triangles through which a ray from it leaves,
// minus the number through which it enters. Returns nothing if, within rounding, the ray meets an edge or the point is
// on a triangle. Requires a unit direction. Cost about O(log n) plus the number of triangles that the ray meets.
std::optional<int> winding_along(const BlockTree& tree, const Vec3& point, const Vec3& direction) {
  return RayWalk(tree, point, direction).run();
}

}  // namespace

struct Surface::Shared {
  IndexedMesh own_mesh{};
  const IndexedMesh* mesh = nullptr;
  const BlockTree* given_tree = nullptr;
  unsigned threads = 0;
  std::optional<bool> known_solid{};  ///< set for a boundary that was made by boundary()
  bool is_cut = false;                ///< only faces, not edges or vertices, show the side

  /// A value that its first caller makes.
  template <class T>
  struct OnDemand {
    template <class Make>
    const T& get(Make make) const {
      if (!is_made.load(std::memory_order_acquire)) {  // cheaper than call_once, which calls a library function
        std::call_once(once, [&] {
          value = make();
          is_made.store(true, std::memory_order_release);
        });
      }
      return value;
    }
    mutable std::once_flag once;
    mutable std::atomic<bool> is_made = false;
    mutable T value{};
  };
  OnDemand<BlockTree> own_tree{};
  OnDemand<VertexTriangles> around{};
  OnDemand<bool> is_solid{};
  OnDemand<SurfaceSign> sign{};
  OnDemand<std::optional<Surface>> boundary{};
};

Surface::Surface(const IndexedMesh& mesh, unsigned threads) {
  const auto shared = std::make_shared<Shared>();
  shared->mesh = &mesh;
  shared->threads = threads;
  shared_ = shared;
}

Surface::Surface(IndexedMesh&& mesh) {
  const auto shared = std::make_shared<Shared>();
  shared->own_mesh = std::move(mesh);
  shared->mesh = &shared->own_mesh;
  shared_ = shared;
}

Surface::Surface(const IndexedMesh& mesh, const BlockTree& tree) {
  const auto shared = std::make_shared<Shared>();
  shared->mesh = &mesh;
  shared->given_tree = &tree;
  shared_ = shared;
}

const IndexedMesh& Surface::mesh() const { return *shared_->mesh; }

const BlockTree& Surface::tree() const {
  if (shared_->given_tree != nullptr) return *shared_->given_tree;
  return shared_->own_tree.get([&] { return build_block_tree({shared_->mesh, 1}, shared_->threads); });
}

const VertexTriangles& Surface::triangles_at_vertices() const {
  return shared_->around.get([&] { return VertexTriangles(mesh()); });
}

bool Surface::is_solid() const {
  if (shared_->known_solid) return *shared_->known_solid;
  return shared_->is_solid.get([&] { return find_mesh_findings(mesh()).is_solid(); });
}

const Surface& Surface::boundary() const {
  const std::optional<Surface>& made = shared_->boundary.get([&]() -> std::optional<Surface> {
    if (shared_->known_solid || !is_solid()) return std::nullopt;
    auto found = find_solid_boundary(mesh(), tree(), triangles_at_vertices(), shared_->threads);
    if (!found) return std::nullopt;
    const bool has_inside = found->is_known && !found->mesh.triangles.empty();
    const auto shared = std::make_shared<Shared>();
    shared->own_mesh = has_inside ? std::move(found->mesh) : mesh();
    shared->mesh = &shared->own_mesh;
    shared->threads = shared_->threads;
    shared->known_solid = has_inside;
    shared->is_cut = found->is_cut;
    return Surface(std::shared_ptr<const Shared>(shared));
  });
  return made ? *made : *this;
}

std::optional<ClosestPoint> Surface::closest_point(const Vec3& point, double within_mm) const {
  const auto found = closest_triangle(tree(), point, within_mm);
  if (!found) return std::nullopt;
  return signed_closest_point(point, found->triangle, found->foot);
}

ClosestPoint Surface::closest_point_from(const Vec3& point, std::uint32_t near) const {
  const ClosestTriangle found = closest_triangle_from(tree(), point, near);
  return signed_closest_point(point, found.triangle, found.foot);
}

bool Surface::winds_around(const Vec3& point) const {
  // The directions are in general position to faces along axes and diagonals.
  static const std::array<Vec3, 4> kDirections = {
      Vec3(0.1719, 0.2831, 0.9435).normalized(), Vec3(0.9187, -0.3541, 0.1747).normalized(),
      Vec3(-0.2413, 0.9391, -0.2446).normalized(), Vec3(-0.5171, -0.4937, -0.6992).normalized()};
  for (const Vec3& direction : kDirections) {
    if (const std::optional<int> winding = winding_along(tree(), point, direction)) return *winding != 0;
  }
  return is_inside({&mesh(), 1}, point);
}

/// Returns the outward direction at a foot; zero if the winding number must be computed.
Vec3 Surface::outward_at(std::uint32_t triangle, const TrianglePoint& foot) const {
  if (shared_->is_cut) return foot.feature == TriangleFeature::face ? face_normal(triangle) : Vec3(Vec3::Zero());
  const SurfaceSign& sign = shared_->sign.get([&] { return SurfaceSign(mesh(), triangles_at_vertices()); });
  return sign.outward(triangle, foot.feature, foot.index);
}

ClosestPoint Surface::signed_closest_point(const Vec3& point, std::uint32_t triangle, const TrianglePoint& foot) const {
  ClosestPoint result;
  result.point = foot.point;
  result.triangle = triangle;
  result.distance_mm = std::sqrt(foot.distance2_mm2);
  const Vec3 displacement = point - foot.point;
  if (is_solid()) {
    const Vec3 outward = outward_at(triangle, foot);
    const double side = displacement.dot(outward);
    result.is_inside = outward.squaredNorm() > 0 ? side < 0 : winds_around(point);
  }
  result.normal = face_normal(triangle);
  if (result.distance_mm > 0) result.normal = (result.is_inside ? -1.0 : 1.0) / result.distance_mm * displacement;
  return result;
}

}  // namespace gouge

#include "lib/surface/ray_winding.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>

#include "lib/hierarchy/lane_bound.h"
#include "lib/mesh/ray_cone.h"

namespace gouge {
namespace {

constexpr double kRayRounding_mm = 1e-9;
constexpr double kSinglePrecision = 1e-6;  // more than a dozen roundings

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
    // Of coordinates and sums in single precision.
    off_mm_ =
        static_cast<float>(kRayRounding_mm + 2 * tree.rounding_mm + kSinglePrecision * (tree.radius_mm + local.norm()));
  }

  std::optional<int> run() {
    if (!tree_.nodes.empty() && !visit(0)) return std::nullopt;
    return winding_;
  }

 private:
  /// False as soon as something is doubtful.
  bool visit(std::uint32_t index) {
    const NodeBlock& node = tree_.nodes[index];
    for (std::uint32_t i = 0; i < node.count; ++i) {
      const LaneBound lane(tree_, node, i);
      const Vec3 from = lane.center - point_;
      const double along = from.dot(direction_), reach = lane.radius_mm + kRayRounding_mm;
      if (along < -reach || from.squaredNorm() - along * along > reach * reach) continue;
      if (!(node.has_leaves ? visit_leaf(node.child[i]) : visit(node.child[i]))) return false;
    }
    return true;
  }

  /// Those that the line through the ray may cross, as its two sides show.
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
  std::array<float, 2> at_{};                     // ... and where it runs on them, in the tree's frame
  float off_mm_ = 0;
  int winding_ = 0;
};

}  // namespace

std::optional<int> winding_along(const BlockTree& tree, const Vec3& point, const Vec3& direction) {
  return RayWalk(tree, point, direction).run();
}

}  // namespace gouge

#include "lib/hierarchy/closest_triangle.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "lib/base/tolerance.h"
#include "lib/hierarchy/distance_kernel.h"

namespace gouge {
namespace {

constexpr double kDouble = 1.0e-14;    // more than double precision does to a distance, relative to the coordinates
constexpr double kRoundUp = 1 + 1e-6;  // to single precision

class ClosestTriangleSearch {
 public:
  ClosestTriangleSearch(const BlockTree& tree, const Vec3& point, double within_mm) : tree_(tree), point_(point) {
    const Vec3 local = point - tree.origin;
    for (std::size_t k = 0; k < 3; ++k) query_.point[k] = static_cast<float>(local[static_cast<Eigen::Index>(k)]);
    const double size = point.norm() + tree.origin.norm() + tree.radius_mm;
    const double slack_mm = Tolerance::kSingleRounding * local.norm() + kDouble * size;
    query_.node_slack_mm = static_cast<float>(slack_mm * kRoundUp);
    const double farthest_mm = local.norm() + tree.radius_mm;
    query_.triangle_slack_mm =
        static_cast<float>((slack_mm + tree.rounding_mm + DistanceQuery::kTriangleRounding * farthest_mm) * kRoundUp);
    take(within_mm * within_mm);
  }

  /// Begins at a triangle instead of with none.
  void begin_at(std::uint32_t near) { offer(near); }

  std::optional<ClosestTriangle> run() {
    if (tree_.nodes.empty()) return std::nullopt;
    visit_node(0);
    return best_;
  }

 private:
  /// Lanes with their bounds, the nearest first.
  struct Order {
    std::array<std::uint8_t, kBlockLanes> lane;
    std::size_t count = 0;
  };

  static Order nearest_first(std::uint32_t lanes, const Lanes& least_mm) {
    Order order;
    for (; lanes != 0; lanes &= lanes - 1) {
      const auto lane = static_cast<std::uint8_t>(std::countr_zero(lanes));
      std::size_t at = order.count++;
      for (; at > 0 && least_mm[order.lane[at - 1]] > least_mm[lane]; --at) order.lane[at] = order.lane[at - 1];
      order.lane[at] = lane;
    }
    return order;
  }

  void visit_node(std::uint32_t index) {
    const NodeBlock& node = tree_.nodes[index];
    Lanes least_mm;
    const Order order = nearest_first(kernel_.nodes(node, query_, within_mm_, least_mm), least_mm);
    for (std::size_t k = 0; k < order.count && least_mm[order.lane[k]] <= within_mm_; ++k) {
      const std::uint32_t child = node.child[order.lane[k]];
      node.has_leaves ? visit_leaf(child) : visit_node(child);
    }
  }

  void visit_leaf(std::uint32_t index) {
    const TriangleBlock& leaf = tree_.leaves[index];
    Lanes least_mm;
    for (std::uint32_t near = kernel_.triangles(leaf, query_, within_mm_, least_mm); near != 0; near &= near - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(near));
      if (least_mm[lane] <= within_mm_) offer(leaf.triangle[lane]);
    }
  }

  void offer(std::uint32_t triangle) {
    const TrianglePoint foot = closest_on_triangle(point_, tree_.corners(triangle));
    const bool is_nearer = foot.distance2_mm2 < best2_;
    const bool is_tie = foot.distance2_mm2 <= best2_ && (!best_ || triangle < best_->triangle);
    if (!is_nearer && !is_tie) return;
    take(foot.distance2_mm2);
    best_ = ClosestTriangle{triangle, foot};
  }

  void take(double best2) {
    best2_ = best2;
    within_mm_ = std::min(within_mm_, static_cast<float>(std::sqrt(best2) * kRoundUp));
  }

  const BlockTree& tree_;
  const Vec3& point_;
  const DistanceKernel& kernel_ = fastest_distance_kernel();
  DistanceQuery query_;
  double best2_ = 0;
  float within_mm_ = std::numeric_limits<float>::infinity();  ///< no less than where the nearest is known to be
  std::optional<ClosestTriangle> best_;
};

}  // namespace

std::optional<ClosestTriangle> closest_triangle(const BlockTree& tree, const Vec3& point_part, double within_mm) {
  return ClosestTriangleSearch(tree, point_part, within_mm).run();
}

ClosestTriangle closest_triangle_from(const BlockTree& tree, const Vec3& point_part, std::uint32_t near) {
  ClosestTriangleSearch search(tree, point_part, std::numeric_limits<double>::infinity());
  search.begin_at(near);
  return *search.run();
}

}  // namespace gouge

#include "lib/hierarchy/closest_triangle.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lib/base/tolerance.h"
#include "lib/hierarchy/distance_kernel.h"
#include "lib/hierarchy/traverse.h"

namespace gouge {
namespace {

constexpr double kDouble = 1.0e-14;    // bound on the rounding of a distance in double precision, relative to the
                                       // coordinates
constexpr double kRoundUp = 1 + 1e-6;  // factor that covers rounding to single precision

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

  /// Starts with a known triangle.
  void begin_at(std::uint32_t near) { offer(near); }

  std::optional<ClosestTriangle> run() {
    traverse(tree_, *this);
    return best_;
  }

  /// The lanes of a node, the nearest first. A lane is returned only if it may be nearer than the best triangle known
  /// at that time.
  class Children {
   public:
    Children(ClosestTriangleSearch& search, const NodeBlock& node) : within_mm_(search.within_mm_) {
      MaskedLanes lanes(search.kernel_.nodes(node, search.query_, within_mm_, min_mm_));
      while (const auto lane = lanes.next()) insert(*lane);
    }
    [[nodiscard]] std::optional<std::uint32_t> next() {
      if (at_ == count_ || min_mm_[order_[at_]] > within_mm_) return std::nullopt;
      return order_[at_++];
    }

   private:
    void insert(std::uint32_t lane) {
      std::size_t at = count_++;
      for (; at > 0 && min_mm_[order_[at - 1]] > min_mm_[lane]; --at) order_[at] = order_[at - 1];
      order_[at] = static_cast<std::uint8_t>(lane);
    }

    float& within_mm_;  // that of the search, which shrinks
    Lanes min_mm_;
    std::array<std::uint8_t, kBlockLanes> order_;
    std::size_t at_ = 0, count_ = 0;
  };

  [[nodiscard]] Children children(const NodeBlock& node) { return {*this, node}; }

  [[nodiscard]] bool visit(const TriangleBlock& leaf) {
    Lanes min_mm;
    MaskedLanes near(kernel_.triangles(leaf, query_, within_mm_, min_mm));
    while (const auto lane = near.next()) {
      if (min_mm[*lane] <= within_mm_) offer(leaf.triangle[*lane]);
    }
    return false;
  }

 private:
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
  float within_mm_ = std::numeric_limits<float>::infinity();  ///< upper bound of the smallest distance
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

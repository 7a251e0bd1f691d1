#include "lib/hierarchy/column_height.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "lib/base/tolerance.h"
#include "lib/hierarchy/bound_leaves.h"
#include "lib/hierarchy/lane_bound.h"
#include "lib/hierarchy/traverse.h"

namespace gouge {
namespace {

class Climb {
 public:
  Climb(const BlockTree& tree, const Column& column, double enough, double most)
      : tree_(tree),
        column_(column),
        through_(column.through - tree.origin),
        enough_(enough),
        max_(most),
        highest_(column.low_mm) {
    axes_[0] = column.direction;
    axes_[1] = column.direction.unitOrthogonal();
    axes_[2] = column.direction.cross(axes_[1]);
    height_ = axes_[0].dot(through_);
    least_[0] = {0, single(-height_ - column.high_mm)};
    for (std::size_t k = 1; k < 3; ++k) {
      const double at = axes_[k].dot(through_);
      least_[k] = {single(at - column.radius_mm), single(-at - column.radius_mm)};
    }
  }

  std::optional<double> run() {
    if (traverse(tree_, *this)) return std::nullopt;
    return highest_;
  }

  /// The lanes of a node that may be higher in the column than the greatest height known at that time.
  class Children {
   public:
    Children(Climb& climb, const NodeBlock& node) : climb_(climb), node_(node) {}
    [[nodiscard]] std::optional<std::uint32_t> next() {
      while (at_ < node_.count) {
        const std::uint32_t lane = at_++;
        if (climb_.may_be_higher(LaneBound(climb_.tree_, node_, lane))) return lane;
      }
      return std::nullopt;
    }

   private:
    Climb& climb_;
    const NodeBlock& node_;
    std::uint32_t at_ = 0;
  };

  [[nodiscard]] Children children(const NodeBlock& node) { return {*this, node}; }

  /// Returns true as soon as a triangle is higher than the maximum.
  [[nodiscard]] bool visit(const TriangleBlock& leaf) {
    MaskedLanes lanes(near_lanes(leaf));
    while (const auto i = lanes.next()) {
      const std::uint32_t triangle = leaf.triangle[*i];
      const double height = height_of(tree_.corners(triangle));
      if (height > max_) return true;
      highest_ = std::max(highest_, height);
    }
    return false;
  }

 private:
  /// Returns the triangles that are not beside the column, and are not lower than the greatest known height. Most are.
  [[nodiscard]] std::uint32_t near_lanes(const TriangleBlock& leaf) const {
    const detail::LeafExtent extent = detail::extent_of(leaf, axes_);
    std::array<std::uint8_t, kBlockLanes> is_near;
    is_near.fill(1);
    for (std::size_t k = 0; k < 3; ++k) {
      const float high = k == 0 ? single(height_ + highest_) : least_[k].high, low = least_[k].low;
      for (std::size_t i = 0; i < kBlockLanes; ++i) {
        is_near[i] = static_cast<std::uint8_t>(is_near[i] & static_cast<std::uint8_t>(extent.high[k][i] >= high) &
                                               static_cast<std::uint8_t>(extent.low[k][i] >= low));
      }
    }
    std::uint32_t mask = 0;
    for (std::uint32_t i = 0; i < leaf.count; ++i) mask |= static_cast<std::uint32_t>(is_near[i]) << i;
    return mask;
  }

  /// Returns whether to enter a lane. A lane that ends at or below the cutoff is not entered: its bound is taken as the
  /// height.
  [[nodiscard]] bool may_be_higher(const LaneBound& lane) {
    const Vec3 from = lane.center - column_.through;
    const double height = column_.direction.dot(from);
    if (height + lane.radius_mm <= highest_ || height - lane.radius_mm > column_.high_mm) return false;
    const double beside2 = from.squaredNorm() - height * height;
    const double reach = column_.radius_mm + lane.radius_mm + Tolerance::kRounding_mm;
    if (beside2 > reach * reach) return false;
    const double up = lane.extent_mm(column_.direction) + Tolerance::kRounding_mm;
    const double down = lane.extent_mm(-column_.direction) + Tolerance::kRounding_mm;
    if (height + up <= highest_ || height - down > column_.high_mm) return false;
    if (height + up > enough_) return true;
    highest_ = std::max(highest_, height + up);
    return false;
  }

  /// Returns an upper bound of the height of the triangle in the column; low_mm if it does not reach into the column.
  [[nodiscard]] double height_of(const std::array<Vec3, 3>& corners) const {
    std::array<Vec3, 3> from;
    std::array<double, 3> heights;
    for (std::size_t k = 0; k < 3; ++k) {
      from[k] = corners[k] - column_.through;
      heights[k] = column_.direction.dot(from[k]);
      from[k] -= heights[k] * column_.direction;
    }
    const auto [low, high] = std::minmax({heights[0], heights[1], heights[2]});
    if (high <= column_.low_mm || low > column_.high_mm) return column_.low_mm;
    if (is_beside(from)) return column_.low_mm;
    const Vec3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    const double along = std::abs(column_.direction.dot(normal));
    double highest = high;
    if (along > Tolerance::kNoSide * normal.norm()) {
      // The height of the plane on the axis of the column, and its rise from there.
      const double middle = normal.dot(corners[0] - column_.through) / column_.direction.dot(normal);
      const double across = std::sqrt(std::max(0.0, normal.squaredNorm() - along * along));
      highest = std::min(highest, middle + across / along * column_.radius_mm);
    }
    return highest + Tolerance::kRounding_mm;
  }

  /// Returns whether the triangle, seen along the column, is proved to miss the column's disc. The proof is a line
  /// through an edge, or a line through its nearest corner, square to the direction of that corner.
  [[nodiscard]] bool is_beside(const std::array<Vec3, 3>& flat) const {
    const double reach = column_.radius_mm + Tolerance::kRounding_mm;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& a = flat[k];
      const Vec3& b = flat[(k + 1) % 3];
      const Vec3& c = flat[(k + 2) % 3];
      const Vec3 edge = b - a;
      const double length2 = edge.squaredNorm();
      if (!(length2 > 0)) continue;
      // The point of the line nearest to the axis; the third corner must be beyond it.
      const Vec3 foot = a - (a.dot(edge) / length2) * edge;
      const double distance = foot.norm();
      if (distance > reach && foot.dot(c) >= distance * distance) return true;
    }
    for (const Vec3& corner : flat) {
      const double distance = corner.norm();
      if (!(distance > reach)) continue;
      const bool all_beyond =
          std::all_of(flat.begin(), flat.end(), [&](const Vec3& x) { return corner.dot(x) > reach * distance; });
      if (all_beyond) return true;
    }
    return false;
  }

  /// Returns a limit of an extent in single precision, low enough for all rounding.
  [[nodiscard]] float single(double limit) const {
    return static_cast<float>(limit - off_mm_ - Tolerance::kSingleRounding * std::abs(limit));
  }

  const BlockTree& tree_;
  const Column& column_;
  Vec3 through_;
  double enough_, max_, highest_;
  std::array<Vec3, 3> axes_;  // the direction of the column, and two directions across it
  double height_ = 0;         // height of the column's point along the first axis, in the tree's frame
  struct Least {
    float high = 0, low = 0;
  };
  std::array<Least, 3> least_;  // minimum extents, along the axes and against them, of a triangle that is not beside
  // The error of single precision is less than eight units of the largest coordinate in the tree's frame.
  double off_mm_ = 8 * tree_.rounding_mm + Tolerance::kRounding_mm;
};

}  // namespace

std::optional<double> highest_in_column(const BlockTree& tree, const Column& column, double cutoff_mm, double max_mm) {
  return Climb(tree, column, cutoff_mm, max_mm).run();
}

}  // namespace gouge

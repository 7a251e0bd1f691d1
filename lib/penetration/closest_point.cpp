#include "lib/penetration/closest_point.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "lib/mesh/winding.h"

namespace gouge {
namespace {

constexpr float kSingle = 4.0F / (1 << 24), kFilterSlack = 8;
constexpr std::size_t kCacheLine = 64;
constexpr double kRoundUp = 1 + 1e-6;

class Search {
 public:
  Search(const DepthBody& body, const Vec3& point, double within_mm)
      : body_(body),
        point_(point),
        single_{static_cast<float>(point.x()), static_cast<float>(point.y()), static_cast<float>(point.z())},
        slack_mm_(kFilterSlack * (body.slack_mm + kSingle * static_cast<float>(point.cwiseAbs().maxCoeff()))) {
    take(within_mm * within_mm);
  }

  std::optional<ClosestPoint> run() {
    if (body_.blocks.empty()) return std::nullopt;
    visit(0);
    if (!has_closest_point_) return std::nullopt;
    return signed_closest_point(body_, point_, slot_, foot_);
  }

 private:
  static constexpr std::size_t kLanes = BoundBlock::kLanes;

  /// Nearest first.
  void visit(std::uint32_t index) {
    const BoundBlock& block = body_.blocks[index];
    alignas(32) std::array<float, kLanes> least;
    kernel_.least_mm(block, single_.data(), slack_mm_, least.data());
    std::array<std::uint32_t, kLanes> near;
    std::size_t count = 0;
    for (std::uint32_t lane = 0; lane < kLanes; ++lane) {
      if (!(least[lane] <= best_mm_)) continue;
      prefetch(block.below[lane]);
      std::size_t at = count++;
      for (; at > 0 && least[near[at - 1]] > least[lane]; --at) near[at] = near[at - 1];
      near[at] = lane;
    }
    for (std::size_t k = 0; k < count && least[near[k]] <= best_mm_; ++k) {
      const std::uint32_t below = block.below[near[k]];
      (below & BoundBlock::kIsFacet) != 0 ? offer(below & ~BoundBlock::kIsFacet) : visit(below);
    }
  }

  void prefetch(std::uint32_t below) const {
    const bool is_facet = (below & BoundBlock::kIsFacet) != 0;
    const auto* const at = is_facet
                               ? reinterpret_cast<const char*>(body_.corners.data() + (below & ~BoundBlock::kIsFacet))
                               : reinterpret_cast<const char*>(body_.blocks.data() + below);
    const std::size_t bytes = is_facet ? sizeof(body_.corners[0]) : sizeof(BoundBlock);
    for (std::size_t k = 0; k < bytes; k += kCacheLine) __builtin_prefetch(at + k);
  }

  void offer(std::uint32_t slot) {
    const TrianglePoint foot = closest_on_triangle(point_, body_.corners[slot]);
    const bool is_nearer = has_closest_point_ ? foot.distance2_mm2 < best2_ : foot.distance2_mm2 <= best2_;
    if (!is_nearer) return;
    take(foot.distance2_mm2);
    foot_ = foot;
    slot_ = slot;
    has_closest_point_ = true;
  }

  void take(double best2) {
    best2_ = best2;
    best_mm_ = static_cast<float>(std::sqrt(best2) * kRoundUp);
  }

  const DepthBody& body_;
  const Vec3& point_;
  const BoundKernel& kernel_ = fastest_bound_kernel();
  std::array<float, 3> single_;
  float slack_mm_;  ///< single precision may be off by this; the point may be farther out than the body
  double best2_ = 0;
  float best_mm_ = 0;  ///< its root or a little more
  TrianglePoint foot_;
  std::uint32_t slot_ = 0;
  bool has_closest_point_ = false;
};

}  // namespace

ClosestPoint signed_closest_point(const DepthBody& body, const Vec3& point, std::uint32_t slot,
                                  const TrianglePoint& foot) {
  ClosestPoint result;
  result.point = foot.point;
  result.triangle = body.tree.order[slot];
  result.slot = slot;
  result.distance_mm = std::sqrt(foot.distance2_mm2);
  const Vec3 displacement = point - foot.point;
  const Vec3 outward = body.sign.outward(result.triangle, foot.feature, foot.index);
  const double side = displacement.dot(outward);
  result.is_inside = outward.squaredNorm() > 0 ? side < 0 : is_inside({&body.mesh, 1}, point);
  result.normal = body.sign.face(result.triangle);
  if (result.distance_mm > 0) result.normal = (result.is_inside ? -1.0 : 1.0) / result.distance_mm * displacement;
  return result;
}

std::optional<ClosestPoint> closest_point(const DepthBody& body, const Vec3& point, double within_mm) {
  return Search(body, point, within_mm).run();
}

}  // namespace gouge

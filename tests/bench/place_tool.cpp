#include "tests/bench/place_tool.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lib/base/parallel.h"

namespace gouge::bench {
namespace {

constexpr double kClearanceError_mm = 0.0001;
constexpr std::size_t kChunk = 250;

struct Stand {
  Pose pose;     ///< touching the true surface's tangent plane at the curve point
  Vec3 outward;  ///< the surface's normal there
};

Stand stand_on_surface(const PartPlan& plan, const BenchTool& tool, const CurvePoint& c, double holder_lean) {
  constexpr double kDegree = std::numbers::pi / 180;
  const Vec3 normal = normal_at(plan.height, c.x_mm, c.y_mm);
  const Vec3 level(c.forward.x(), c.forward.y(), 0);
  const Vec3 forward = (level - level.dot(normal) * normal).normalized();
  const Vec3 side = normal.cross(forward);
  const double lead = c.lead_deg * (1 - c.holder_share) * kDegree;
  const double tilt = (c.tilt_deg + (holder_lean - c.tilt_deg) * c.holder_share) * kDegree;
  const Vec3 axis = (normal + std::tan(lead) * forward + std::tan(tilt) * side).normalized();
  const Vec3 touch(c.x_mm, c.y_mm, plan.height(c.x_mm, c.y_mm));
  return {{touch - support_offset(tool.lower, axis, -normal), axis}, normal};
}

Pose pushed(const Stand& stand, double push) { return {stand.pose.tip + push * stand.outward, stand.pose.axis}; }

/// How far to push out so that the lower piece clears the mesh by kClearance_mm. A secant whose slope is held
/// to what a contact's normal can make it; the distance is 1-Lipschitz in the push.
double find_push(const BenchTool& tool, const ExactDistance& mesh, const Stand& stand, double guess) {
  double push = guess, slope = 1, last_push = 0, last_value = 0;
  for (int step = 0; step < 60; ++step) {
    const double value = mesh.minimum(tool.lower, pushed(stand, push), kFar_mm, 1e-5).distance_mm - kClearance_mm;
    if (std::abs(value) <= kClearanceError_mm) break;
    if (step > 0) slope = std::clamp((value - last_value) / (push - last_push), 0.25, 1.0);
    last_push = push;
    last_value = value;
    push -= value / slope;
  }
  return push;
}

PlacedPose with_truth(const BenchTool& tool, const ExactDistance& mesh, const Pose& pose, bool is_air) {
  PlacedPose placed;
  placed.pose = pose;
  placed.lower_mm = mesh.minimum(tool.lower, pose, kFar_mm, kTruthAccuracy_mm).distance_mm;
  placed.holder_mm = mesh.minimum(tool.holder, pose, kFar_mm, kTruthAccuracy_mm).distance_mm;
  placed.is_air = is_air ? 1 : 0;
  return placed;
}

/// Tilt at which the holder comes as deep as the plan wants at this point of the curve.
double find_holder_lean(const PartPlan& plan, const BenchTool& tool, const ExactDistance& mesh, CurvePoint c,
                        double push) {
  c.holder_share = 1;
  double low = 30, high = 80;
  for (int step = 0; step < 20; ++step) {
    const double lean = 0.5 * (low + high);
    const Stand stand = stand_on_surface(plan, tool, c, lean);
    const Pose pose = pushed(stand, find_push(tool, mesh, stand, push));
    const double holder = mesh.minimum(tool.holder, pose, 0, 1e-4).distance_mm;
    (holder < -c.holder_depth_mm ? high : low) = lean;
  }
  return low;
}

}  // namespace

std::vector<PlacedPose> place_tool(const PartPlan& plan, const BenchTool& tool, const ExactDistance& mesh,
                                   std::size_t density, unsigned threads) {
  std::vector<PlacedPose> placed(plan.positions * density);
  for_each_chunk(placed.size(), kChunk, threads, [&](std::size_t first, std::size_t last) {
    double push = 0;
    for (std::size_t i = first; i < last; ++i) {
      const CurvePoint c = plan.curve(static_cast<double>(i) / static_cast<double>(density));
      const double lean = c.holder_share > 0 ? find_holder_lean(plan, tool, mesh, c, push) : 0;
      const Stand stand = stand_on_surface(plan, tool, c, lean);
      Pose pose = stand.pose;
      if (c.lift_mm > 0) {
        pose.tip.z() += c.lift_mm;
      } else {
        push = find_push(tool, mesh, stand, push);
        pose = pushed(stand, push - (c.dip_mm > 0 ? c.dip_mm + kClearance_mm : 0));
      }
      placed[i] = with_truth(tool, mesh, pose, c.lift_mm > 0);
    }
  });
  return placed;
}

}  // namespace gouge::bench

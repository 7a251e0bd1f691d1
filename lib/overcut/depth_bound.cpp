#include "lib/overcut/depth_bound.h"

#include <algorithm>
#include <cmath>

#include "lib/check/overcut_gap.h"

namespace gouge {
namespace {

constexpr double kSlack_mm = 0.1 * kOvercutGap_mm;
constexpr double kRegionRounding = 2e-5;  // share of the height: twice the length that RegionFinder ignores
constexpr double kSteps = 8;              // number of steps from a depth to its double

}  // namespace

DepthBound::DepthBound(const CompiledTool& tool)
    : tool_(tool), balls_(tool, kSlack_mm), regions_(tool), cover_(make_convex_cover(tool)) {}

int DepthBound::step_of(double depth_mm) { return static_cast<int>(std::ceil(kSteps * std::log2(depth_mm))); }

DepthBound::Step DepthBound::make_step(double depth_mm) const {
  const double deeper_mm = depth_mm + kRegionRounding * (tool_.z_max_mm - tool_.z_min_mm);
  return {regions_.at(depth_mm).regions, balls_.sharp_zones(deeper_mm)};
}

void DepthBound::prepare(double depth_upper_mm) {
  if (!balls_.is_single_valued() || !(depth_upper_mm > 0)) return;
  const int step = step_of(depth_upper_mm);
  if (!steps_.contains(step)) steps_[step] = make_step(std::max(depth_upper_mm, std::exp2(step / kSteps)));
  if (steps_[step].regions.empty() && !exact_.contains(depth_upper_mm))
    exact_[depth_upper_mm] = make_step(depth_upper_mm);
}

std::optional<RoundedReach> DepthBound::at(double depth_upper_mm, const Motion& motion, const Surface& part) const {
  if (!balls_.is_single_valued() || !(depth_upper_mm > 0)) return std::nullopt;
  const auto exact = exact_.find(depth_upper_mm);
  const Step& step = exact != exact_.end() ? exact->second : steps_.at(step_of(depth_upper_mm));
  const Pose pose = motion.at(0);
  const Vec3 across = pose.axis.unitOrthogonal();
  const auto is_outside = [&](const FreeRegion& region) {
    const Vec3 deepest = pose.tip + region.deepest.y() * pose.axis + region.deepest.x() * across;
    return !part.closest_point(deepest)->is_inside;
  };
  if (step.regions.empty() || !std::all_of(step.regions.begin(), step.regions.end(), is_outside)) return std::nullopt;
  return RoundedReach{depth_upper_mm, kSlack_mm, &step.sharp_zones, &cover_};
}

}  // namespace gouge

#include "lib/overcut/depth_bound.h"

#include <algorithm>

#include "lib/check/overcut_gap.h"

namespace gouge {
namespace {

constexpr double kSlack_mm = 0.1 * kOvercutGap_mm;
constexpr double kRegionRounding = 2e-5;  // of the height: what RegionFinder passes over, twice

}  // namespace

DepthBound::DepthBound(const CompiledTool& tool) : tool_(tool), balls_(tool, kSlack_mm), regions_(tool) {}

std::optional<KnownOvercut> DepthBound::at(double depth_upper_mm, const Motion& motion, const Surface& part) const {
  if (!balls_.is_single_valued()) return std::nullopt;
  const FreeRegions free = regions_.at(depth_upper_mm);
  const Pose pose = motion.at(0);
  const Vec3 across = pose.axis.unitOrthogonal();
  const auto is_outside = [&](const FreeRegion& region) {
    const Vec3 deepest = pose.tip + region.deepest.y() * pose.axis + region.deepest.x() * across;
    return !part.closest_point(deepest)->is_inside;
  };
  if (free.regions.empty() || !std::all_of(free.regions.begin(), free.regions.end(), is_outside)) return std::nullopt;
  const double deeper = depth_upper_mm + kRegionRounding * (tool_.z_max_mm - tool_.z_min_mm);
  return KnownOvercut{depth_upper_mm + kSlack_mm, balls_.sharp_zones(deeper)};
}

}  // namespace gouge

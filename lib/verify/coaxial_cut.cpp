#include "lib/verify/coaxial_cut.h"

#include <algorithm>

#include "lib/verify/contour_radii.h"

namespace gouge {

namespace {

/// Returns a bound of the distance of the points of a cylinder about the tool axis from the axis of a cutter on its way. A
/// point p at the radius r about the tool axis a through `tip` is at most r + |(tip - c) x b| + |p - tip| |a - b| away from
/// the axis b through c. All of this is convex in tip and a.
double distance_from_axis_mm(const DeepPart& part, const PatchHeights& heights, double radius_mm,
                             const CutPoses& poses) {
  const Bounds3 &axis = poses.first.axis, way = poses.last.tip - poses.first.tip;
  double off = 0, lean = 0;
  for (const PoseBounds& pose : part.span.poses) {
    const Bounds3 from = pose.tip - poses.first.tip;
    const Bounds share(share_on_way(from.middle(), way.middle(), axis.middle()));
    off = std::max(off, length(cross(from - share * way, axis)).sup());
    lean = std::max(lean, length(pose.axis - axis).sup());
  }
  const Bounds sag(part.span.sag_mm), reach = Bounds(heights.reach_mm) + sag;
  return (Bounds(radius_mm) + Bounds(off) + sag + reach * (Bounds(lean) + Bounds(part.span.bend))).sup();
}

}  // namespace

// A point that is deep in the body is the centre of a ball in it. So the body reaches a radius larger by the depth at the
// height of the point.
bool is_deep_part_within(const DeepPart& part, const ToolContour& cutter, const CutPoses& poses, double wider_mm) {
  const PatchHeights heights = heights_of(block_patch(part.block), part.span);
  const double radius =
      (Bounds(widest_radius_mm(part.body, heights.low_mm, heights.high_mm)) - Bounds(part.depth_mm)).sup();
  if (radius < 0) return true;
  return has_cylinder(cutter, distance_from_axis_mm(part, heights, radius, poses), heights_between(part.block, poses),
                      wider_mm);
}

}  // namespace gouge

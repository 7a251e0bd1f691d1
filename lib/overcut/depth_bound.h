#pragma once

#include <map>
#include <optional>
#include <vector>

#include "lib/motion/motion.h"
#include "lib/overcut/swept_tool.h"
#include "lib/surface/surface.h"
#include "lib/tool/compiled_tool.h"
#include "lib/tool/convex_cover.h"
#include "lib/tool/free_regions.h"
#include "lib/tool/inscribed_balls.h"

namespace gouge {

/// The reach of a tool below a surface, derived from the depth of the surface in the tool. Except near sharp corners,
/// and where the tool is thin, the reach does not exceed the depth. The part of the tool that the surface does not
/// reach is outside. A ball inscribed there leads from every other point to the surface.
/// Proof: docs/method/overcut.md, section 2.
class DepthBound {
 public:
  /// Prepares the bound. Cost: some thousand evaluations of the tool, which must outlive it.
  explicit DepthBound(const CompiledTool& tool);

  /// Prepares the bound for a depth. Not to be called beside `at`.
  void prepare(double depth_upper_mm);

  /// Returns the bound for a motion during which the surface of `part` is nowhere deeper in the tool than
  /// `depth_upper_mm`. Returns nothing if the depth does not bound the reach. That is so for a tool that turns back in
  /// height, is thinner than twice the depth, or has a core in the part.
  /// Requires the boundary of a solid, and a depth that was prepared. The result refers to this object.
  [[nodiscard]] std::optional<RoundedReach> at(double depth_upper_mm, const Motion& motion, const Surface& part) const;

 private:
  /// Regions and zones for all depths up to a step.
  struct Step {
    std::vector<FreeRegion> regions;
    std::vector<Box2> sharp_zones;
  };
  static int step_of(double depth_mm);
  [[nodiscard]] Step make_step(double depth_mm) const;

  const CompiledTool& tool_;
  InscribedBalls balls_;
  RegionFinder regions_;
  ConvexCover cover_;
  std::map<int, Step> steps_;
  std::map<double, Step> exact_;  // for depths whose step has no region
};

}  // namespace gouge

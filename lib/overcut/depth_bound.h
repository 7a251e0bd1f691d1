#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "lib/check/motion.h"
#include "lib/surface/surface.h"
#include "lib/tool/free_regions.h"
#include "lib/tool/inscribed_balls.h"

namespace gouge {

/// What is known of an overcut from the depth of the move.
struct KnownOvercut {
  double upper_mm = 0;            ///< outside of the zones no point of the tool is farther below the surface
  std::vector<Box2> sharp_zones;  ///< of the tool's half plane
};

/// How far a tool reaches below a surface that comes only so deep into it. Except near sharp corners and where the
/// tool is thin that is no more than the depth: the part of the tool that the surface does not reach is outside, and a
/// ball inscribed there leads from every other point to the surface.
/// Proof: docs/algorithms/overcut.md, section 2.
class DepthBound {
 public:
  /// Cost: some thousand evaluations of the tool, which must outlive it.
  explicit DepthBound(const CompiledTool& tool);

  /// `depth_upper_mm`: nowhere during the motion is the surface of `part` deeper in the tool. Nothing where the depth
  /// tells nothing: of a tool that turns back in height, or thinner than twice the depth, or with a core in the part.
  /// Requires part.is_solid().
  [[nodiscard]] std::optional<KnownOvercut> at(double depth_upper_mm, const Motion& motion, const Surface& part) const;

 private:
  const CompiledTool& tool_;
  InscribedBalls balls_;
  RegionFinder regions_;
};

}  // namespace gouge

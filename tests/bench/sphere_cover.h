#pragma once

#include <vector>

#include "tests/bench/bench_tool.h"

// Spheres that together cover a tool, for engines whose only question is what lies within a distance of a
// point. In tool coordinates.

namespace gouge::bench {

struct CoverSphere {
  Vec3 center = Vec3::Zero();
  double radius_mm = 0;
};

struct SphereCover {
  double bulge_mm = 0;
  std::vector<CoverSphere> lower, holder;
};

/// Where the tool works, at its end, the spheres stand out of it by about `bulge_mm`, below a flat bottom by
/// `disc_bulge_mm`; higher up by more.
[[nodiscard]] SphereCover cover_tool(const BenchTool& tool, double bulge_mm, double disc_bulge_mm);

/// How far a point of the tool may lie outside every sphere, tried on a fine grid of its surface and inside;
/// at most 0 for a sound cover.
[[nodiscard]] double uncovered_mm(const BenchTool& tool, const SphereCover& cover);

}  // namespace gouge::bench

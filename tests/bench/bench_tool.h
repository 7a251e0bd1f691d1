#pragma once

#include <string>
#include <vector>

#include "lib/tool/tool_variants.h"
#include "tests/bench/convex_piece.h"
#include "toolmodels/assembly.h"

// A tool of the benchmark, once as a user of the library builds it and once as the union of two convex
// pieces. Both describe the same solid: the rounded tops of the lower piece lie within the holder.

namespace gouge::bench {

struct BenchTool {
  std::string name;  ///< "ball", "bull" or "taper"
  ToolAssembly assembly;
  ToolVariants variants;
  ConvexPiece lower;  ///< cutter and shank
  ConvexPiece holder;
};

/// Where the holder stands and how wide it is; shared by the three tools of a part.
struct HolderSize {
  double diameter_mm = 32, z0_mm = 40, z1_mm = 90;
};

[[nodiscard]] BenchTool make_ball(double diameter_mm, const HolderSize& holder);
[[nodiscard]] BenchTool make_bull(double diameter_mm, double corner_mm, const HolderSize& holder);
[[nodiscard]] BenchTool make_taper(double diameter_mm, double angle_deg, const HolderSize& holder);

}  // namespace gouge::bench

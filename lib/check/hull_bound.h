#pragma once

#include <array>

#include "lib/check/support_plane.h"
#include "lib/motion/tool_interval.h"

// Upper bounds of (reach - signed distance) over a part of the surface during a time interval. In tool coordinates
// every surface point stays within `bulge` of a straight chord. So the moving surface lies, up to `bulge`, in the
// convex hull of two placements of the surface. Proofs: docs/method/certified_sweep.md.

namespace gouge {

struct PieceBound {
  double upper_mm = 0;
  double value_mm = 0;  ///< value at corner `corner` of the piece at one end of the interval
  std::size_t corner = 0;
  bool is_at_end = false;
  bool is_time_next = false;  ///< halving the time lowers the bound more than halving the piece does
};

/// Bounds the value over the triangle `piece`. With reach > 0 the bound is max(0, ...) and is exact only up to the
/// reach. The work stops as soon as the bound is at most `cutoff_mm`.
[[nodiscard]] PieceBound bound_piece(const CompiledTool& tool, const std::array<Vec3, 3>& piece,
                                     const ToolInterval& interval, double reach_mm, double cutoff_mm);

}  // namespace gouge

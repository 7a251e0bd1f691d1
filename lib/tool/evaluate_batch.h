#pragma once

#include <span>

#include "lib/tool/compiled_tool.h"

namespace gouge {

/// Up to here looking at every element of many points at once beats the tree (docs/benchmarks.md).
inline constexpr std::size_t kLoopElements = 8;

/// Signed distances at many points (r[i], z[i]) of the tool half plane, mm.
///
/// Requires  three spans of one length, r >= 0, finite values.
/// Ensures   (1) |distance - evaluate(...)| <= 1e-12 relative to the tool's size; (2) the result for a point
///           depends neither on the other points nor on the instruction set.
/// Cost      tools of up to kLoopElements elements: one pass over all elements, several points at a time, no
///           branches and no allocation; larger ones: evaluate for each point.
/// Source    own, docs/algorithms/tool_voronoi.md
void signed_distances(const CompiledTool& tool, std::span<const double> r, std::span<const double> z,
                      std::span<double> distances_mm);

/// The two methods by themselves, for whoever compares them.
void signed_distances_by_tree(const CompiledTool& tool, std::span<const double> r, std::span<const double> z,
                              std::span<double> distances_mm);
/// Requires tool.borders as compile_tool fills them.
void signed_distances_by_loop(const CompiledTool& tool, std::span<const double> r, std::span<const double> z,
                              std::span<double> distances_mm);

}  // namespace gouge

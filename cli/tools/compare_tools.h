#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lib/base/diagnostic.h"
#include "lib/path/toolpath.h"
#include "toolmodels/tool_library.h"

namespace gouge {

/// Use of a tool of the library. It decides whether a tool that is larger than that of the path can hide anything.
enum class ToolUse {
  finds_gouges,  ///< it cannot: it gouges wherever the smaller tool does
  removes_stock  ///< it can: it also removes material that the smaller tool leaves
};

/// The length of a tool from its tip to the gauge point of the spindle, as --tool-length states it.
struct GaugeLength {
  std::optional<double> mm = {};  ///< none: not stated
  double slack_mm = 0;            ///< the true length is at most so much longer or shorter
};

/// The surroundings of a comparison of tools.
struct ToolSetUp {
  const ToolLibrary& library;
  const std::vector<ToolSegment>& holder;  ///< of tools without one; may be empty
  ToolUse use;
  GaugeLength length;  ///< of the only tool of a path that states none itself
};

/// The differences between a tool of the library and that of the path.
struct ToolDifference {
  std::string contradiction;  ///< one sentence, or several joined by semicolons; empty: none that could hide anything
  std::string doubt;          ///< a fact that is no contradiction, but must be listed; empty: none
  Diagnostics warnings;       ///< about the other differences; code tool-differs
};

/// Returns "T7", or the name of a tool without a number.
[[nodiscard]] std::string name_of(const PathTool& tool);

/// Returns the length to the gauge line that LENGTH in a loading states. Nothing: it states none, or that of the cutter, as
/// some CAM systems do.
[[nodiscard]] std::optional<double> loaded_gauge_length_mm(const PathTool& tool);

/// Compares the tool `known` of the library, which is checked, with that of the path. If it is smaller, or ends below a
/// length that the path states, a gouge of the path's tool could be missed. If it is larger, no gouge is missed. A larger
/// tool removes more stock, so it could miss a rapid into material. Where both state a length to the gauge line, lengths
/// that differ by more than 1 mm contradict each other: measured lengths differ by less from those of a library. A
/// measured radius of a tool table may differ by 0.01 mm, which is a doubt.
[[nodiscard]] ToolDifference compare_tools(const PathTool& tool, const ToolAssembly& known, const Toolpath& path,
                                           const ToolSetUp& set_up);

}  // namespace gouge

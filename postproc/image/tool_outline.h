#pragma once

#include <vector>

#include "lib/tool/compiled_tool.h"
#include "postproc/image/surface_buffer.h"

namespace gouge {

/// A part of the profile of a tool, for a run of elements of one body. It is a broken line (r, z) in mm, from the tip
/// up.
struct OutlineRun {
  Body body = Body::cutter;
  std::vector<Vec2> points;
};
[[nodiscard]] std::vector<OutlineRun> tool_outline(const CompiledTool& tool);

/// Returns the profile of the region within `distance_mm` > 0 of a tool, as pieces of lines (r, z) in mm.
[[nodiscard]] std::vector<std::vector<Vec2>> outline_at(const CompiledTool& tool, double distance_mm);

/// Lowest and highest z of a body's boundary; first > second if it has none.
struct BodyRange {
  double low_mm = 1, high_mm = 0;
};
[[nodiscard]] BodyRange body_range(const CompiledTool& tool, Body body);

/// The tool as a surface in part coordinates.
struct ToolSurface {
  std::vector<Vec3> vertices;
  std::vector<FaceCorners> faces;
  std::vector<Body> bodies;  ///< for each face
};
[[nodiscard]] ToolSurface tool_surface(const CompiledTool& tool, const Pose& pose);

}  // namespace gouge

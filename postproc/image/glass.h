#pragma once

#include "postproc/image/picture_scene.h"
#include "postproc/image/raster.h"
#include "postproc/image/surface_buffer.h"
#include "postproc/image/tool_outline.h"

namespace gouge {

/// Lays the tool and the heads (both in part coordinates) over the picture of a part, like clear glass. The nearer body
/// is over the farther one; where the part hides them, a faint trace remains. Lines show their outlines and the edges
/// of the heads.
void lay_glass(Raster& raster, const SurfaceBuffer& part, const ToolSurface& tool, const PictureScene& heads);

}  // namespace gouge

#pragma once

#include "postproc/image/picture_scene.h"
#include "postproc/image/raster.h"
#include "postproc/image/surface_buffer.h"
#include "postproc/image/tool_outline.h"

namespace gouge {

/// Lays the tool and the heads (both in part coordinates) over the picture of a part, like clear glass. The nearer is
/// over the farther, with a faint trace where the part hides them. Lines run along their outlines and the edges of the
/// heads.
void lay_glass(Raster& raster, const SurfaceBuffer& part, const ToolSurface& tool, const PictureScene& heads);

}  // namespace gouge

#pragma once

#include <vector>

#include "lib/check/check_result.h"
#include "postproc/image/colour_scale.h"
#include "postproc/image/picture_events.h"
#include "postproc/image/surface_buffer.h"

// Material left on the part, in the pictures of its surface.

namespace gouge {

/// Returns whether a result has material that pictures show.
[[nodiscard]] bool shows_material_left(const CheckResult& result);

/// Adds the material left to a scale of the surface.
void add_material_left(const CheckResult& result, LengthUnit unit, ColourScale& scale);

/// Enters the material left, as negative values, into the depths of the pixels of a buffer. Depths stay. `depth_mm` is
/// empty or has one value for each pixel.
void add_material_left(const CheckResult& result, const SurfaceBuffer& buffer, std::vector<float>& depth_mm);

/// Returns points of the surface with material, for the choice of a view; at most about `most`.
[[nodiscard]] std::vector<GougeWitness> material_witnesses(const CheckResult& result, std::size_t most);

}  // namespace gouge

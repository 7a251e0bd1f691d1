#pragma once

#include "postproc/image/colour_scale.h"
#include "postproc/viewer/payload.h"
#include "postproc/viewer/refine_surface.h"
#include "postproc/viewer/viewer_mesh.h"

// Writers of the parts of a scene as numbers of a Payload. Each returns its JSON: docs/formats/report_scene.md.

namespace gouge {

/// Writes positions with 16 bits for each axis, on one grid for all three.
[[nodiscard]] nlohmann::ordered_json write_mesh(Payload& payload, const ViewerMesh& mesh);

/// Writes values as places on a colour scale, with 16 bits. Only untouched surface has 0.
[[nodiscard]] nlohmann::ordered_json write_values(Payload& payload, const std::vector<float>& values_mm,
                                                  const ColourScale& scale);

/// Writes stations with the facts about each move: line, tool, kind, state and depth.
[[nodiscard]] nlohmann::ordered_json write_path(Payload& payload, const std::vector<Station>& stations,
                                                const CheckedToolpath& input, const ColourScale& depths);

}  // namespace gouge

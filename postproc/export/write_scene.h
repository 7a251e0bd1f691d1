#pragma once

#include <string>

#include "lib/base/result.h"
#include "postproc/export/export_scene.h"

// Writes a scene in the formats of other programs: docs/formats/scene.md. The values are sampled like those of the
// report's pictures; the numbers of a verdict are those of the JSON. The bytes are equal on every run. Error of all
// functions: scene-too-large, if the format cannot express so many bytes or vertices.

namespace gouge {

/// Returns glTF 2.0 in one binary file, for Blender and viewers: metres, y up, by the transform of its root. It has
/// custom attributes _DEPTH and _OVERCUT in mm, and one mesh of lines for each state of the path.
[[nodiscard]] Result<std::string> write_glb(const ExportScene& scene);

/// Returns VTK PolyData (XML, format "binary"), for ParaView, in the scene's unit. Point data are depth and overcut;
/// cell data are kind, mesh, state and move.
[[nodiscard]] Result<std::string> write_vtp(const ExportScene& scene);

/// Returns PLY (binary, little endian), for MeshLab, Open3D and CGAL, in the scene's unit. Vertices have normal,
/// colour, depth and overcut. It has only parts and fixtures.
[[nodiscard]] Result<std::string> write_ply(const ExportScene& scene);

using WriteScene = Result<std::string> (*)(const ExportScene&);
/// Returns the format of a file by its ending .glb, .vtp or .ply, in upper or lower case; null for any other ending.
[[nodiscard]] WriteScene scene_format_of(const std::string& file);

}  // namespace gouge

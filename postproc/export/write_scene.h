#pragma once

#include <string>

#include "lib/base/result.h"
#include "postproc/export/export_scene.h"

// A scene in the formats of other programs: docs/formats/scene.md. All are a picture of what was found, sampled as the
// report's; the numbers of a verdict are those of the JSON. The same bytes on every run. Error of all: scene-too-large,
// where the format has no number for that many bytes or vertices.

namespace gouge {

/// glTF 2.0 in one binary file, for Blender and viewers: metres, y up, by the transform of its root. Custom attributes
/// _DEPTH and _OVERCUT in mm; one mesh of lines for each state of the path.
[[nodiscard]] Result<std::string> write_glb(const ExportScene& scene);

/// VTK PolyData (XML, format "binary"), for ParaView: in the scene's unit, with point data depth and overcut and cell
/// data kind, mesh, state and move.
[[nodiscard]] Result<std::string> write_vtp(const ExportScene& scene);

/// PLY (binary, little endian), for MeshLab, Open3D and CGAL: in the scene's unit, vertices with normal, colour, depth
/// and overcut. Parts and fixtures alone.
[[nodiscard]] Result<std::string> write_ply(const ExportScene& scene);

using WriteScene = Result<std::string> (*)(const ExportScene&);
/// Returns the format of a file by its ending .glb, .vtp or .ply, in any case; null for others.
[[nodiscard]] WriteScene scene_format_of(const std::string& file);

}  // namespace gouge

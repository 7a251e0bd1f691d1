#pragma once

#include <string>

#include "lib/base/files.h"
#include "lib/base/parallel.h"
#include "lib/base/result.h"
#include "lib/mesh/mesh_builder.h"
#include "lib/mesh/mesh_findings.h"

namespace gouge {

struct LoadedMesh {
  IndexedMesh mesh;  ///< mm, part coordinates
  MeshFindings findings;
  StlFormat format = StlFormat::binary;
  Diagnostics notes;  ///< faults that the reader tolerated, then describe(findings); warnings and notes
};

/// Reads an STL file into a mesh, with remarks about it.
/// Errors: those of read_file, parse_stl and build_mesh.
[[nodiscard]] Result<LoadedMesh> load_mesh(const std::string& path, const MeshPlacement& placement = {},
                                           std::uint64_t max_bytes = kMaxInputBytes, const ProgressCall& progress = {});

/// Returns the same for a file that is already in memory; the file is released as soon as the mesh is welded.
[[nodiscard]] Result<LoadedMesh> load_mesh_view(FileView file, const std::string& name,
                                                const MeshPlacement& placement = {}, const ProgressCall& progress = {});

/// Returns the same for the bytes of a file.
[[nodiscard]] Result<LoadedMesh> load_mesh_bytes(std::string_view bytes, const std::string& name,
                                                 const MeshPlacement& placement = {});

}  // namespace gouge

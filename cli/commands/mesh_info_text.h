#pragma once

#include <optional>
#include <string>

#include "lib/base/units.h"
#include "lib/mesh/load_mesh.h"
#include "lib/validate/repair_mesh.h"

namespace gouge {

/// Effect of joining near vertices.
struct MeshWeld {
  double reach_mm = 0;
  std::size_t vertices_joined = 0;
  double largest_shift_mm = 0;
  std::size_t triangles_collapsed = 0;
  MeshValidation judged;  ///< of the joined mesh
};

/// Content of the report of `gougecheck mesh`.
struct MeshInfo {
  std::string file;
  LengthUnit unit = LengthUnit::mm;  ///< of the file, and of every length shown
  StlFormat format = StlFormat::binary;
  Diagnostics notes;                 ///< of reading and structure
  MeshValidation judged;             ///< of the file as it is
  std::optional<MeshWeld> weld;      ///< when requested
  std::optional<MeshRepair> repair;  ///< when requested and not failed
  std::string written_file;          ///< the repaired STL; empty when none was written
};

/// Returns a table of facts, the verdict and what it means for a check, and what a repair did.
[[nodiscard]] std::string mesh_info_text(const MeshInfo& info);

/// Returns the same for programs; described in docs/formats/stl.md. Lengths in the file's unit.
[[nodiscard]] std::string mesh_info_json(const MeshInfo& info);

}  // namespace gouge

#pragma once

#include <optional>
#include <string>

#include "lib/base/units.h"
#include "lib/mesh/load_mesh.h"
#include "lib/validate/repair_mesh.h"

namespace gouge {

/// Effect of joining vertices that are close to each other.
struct MeshWeld {
  double reach_mm = 0;
  std::size_t vertices_joined = 0;
  double largest_shift_mm = 0;
  std::size_t triangles_collapsed = 0;
  MeshValidation judged;  ///< verdict on the joined mesh
};

/// Content of the report of `gougecheck mesh`.
struct MeshInfo {
  std::string file;
  LengthUnit unit = LengthUnit::mm;  ///< unit of the file, and of every length shown
  StlFormat format = StlFormat::binary;
  Diagnostics notes;                 ///< about reading and structure
  MeshValidation judged;             ///< verdict on the unchanged mesh of the file
  std::optional<MeshWeld> weld;      ///< set if requested
  std::optional<MeshRepair> repair;  ///< set if requested and not failed
  std::string written_file;          ///< the file with the repaired mesh; empty if none was written
};

/// Returns a table of facts, the verdict, its meaning for a check, and the result of a repair.
[[nodiscard]] std::string mesh_info_text(const MeshInfo& info);

/// Returns the report as JSON; described in docs/formats/stl.md. Lengths are in the unit of the file.
[[nodiscard]] std::string mesh_info_json(const MeshInfo& info);

}  // namespace gouge

#pragma once

#include <optional>
#include <string>

#include "lib/base/units.h"
#include "lib/mesh/load_mesh.h"
#include "lib/validate/repair_mesh.h"

namespace gouge {

/// What `gougecheck mesh` has to tell.
struct MeshInfo {
  std::string file;
  LengthUnit unit = LengthUnit::mm;  ///< of the file, and of every length told
  StlFormat format = StlFormat::binary;
  Diagnostics notes;  ///< of reading and structure
  MeshValidation judged;
  std::optional<MeshRepair> repair;  ///< when asked for and not failed
  std::string written_file;          ///< the repaired STL; empty when none was written
};

/// A table of facts, the verdict and what it means for a check, and what a repair did.
[[nodiscard]] std::string mesh_info_text(const MeshInfo& info);

/// The same for programs; described in docs/formats/stl.md. Lengths in the file's unit.
[[nodiscard]] std::string mesh_info_json(const MeshInfo& info);

}  // namespace gouge

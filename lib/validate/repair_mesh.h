#pragma once

#include <cstddef>
#include <string>

#include "lib/base/result.h"
#include "lib/base/units.h"
#include "lib/mesh/indexed_mesh.h"
#include "lib/validate/validate_mesh.h"

namespace gouge {

struct RepairOptions {
  bool fills_holes = false;          ///< adds surface that the file does not have
  LengthUnit unit = LengthUnit::mm;  ///< of the written STL
};

/// The effects of the repair steps, in the order of the steps.
struct RepairSteps {
  std::size_t degenerate_removed = 0;  ///< triangles with identical corners (already left out by build_mesh)
  std::size_t duplicates_removed = 0;
  std::size_t vertices_split = 0;     ///< copies made where surfaces only touched or could not be oriented
  std::size_t borders_stitched = 0;   ///< pairs of border edges joined
  std::size_t collinear_removed = 0;  ///< triangles whose corners lie on one line
  std::size_t collinear_left = 0;     ///< such triangles that could not be removed
  std::size_t holes_filled = 0;
  std::size_t hole_triangles_added = 0;
  std::size_t holes_left = 0;           ///< not requested, or no filling was found
  std::size_t pieces_not_oriented = 0;  ///< closed but flat, so neither side is inside
  std::size_t triangles_turned = 0;     ///< relative to their orientation in the file
};

struct MeshRepair {
  std::string stl_bytes;  ///< the repaired mesh as binary STL in RepairOptions::unit
  IndexedMesh mesh;       ///< read back from stl_bytes
  RepairSteps steps;
  MeshValidation before;
  MeshValidation after;  ///< of `mesh`, so the report holds for the written file

  /// Returns whether the repaired mesh has fewer defects than before. Only then is a file useful.
  [[nodiscard]] bool is_better() const { return after.trouble.empty() && after.defects() < before.defects(); }
};

/// Removes duplicates and triangles without area, orients the triangles consistently, and joins borders with identical
/// coordinates. Splits vertices where surfaces only touch, and fills holes if requested. Turns closed pieces outward
/// (cavities inward). It moves no vertex and resolves no self-intersection.
///
/// Requires a mesh in the frame of its file (no placement), and its validation.
/// Errors   mesh-repair-failed: CGAL could not complete the repair; the message has its reason.
[[nodiscard]] Result<MeshRepair> repair_mesh(const IndexedMesh& mesh, const MeshValidation& before,
                                             const RepairOptions& options, const ProgressCall& progress = {});

}  // namespace gouge

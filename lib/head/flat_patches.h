#pragma once

#include <cstdint>
#include <vector>

#include "lib/mesh/adjacency.h"
#include "lib/mesh/indexed_mesh.h"
#include "lib/surface/surface.h"

namespace gouge {

/// Neighbouring faces of a head in one plane, as one: what lies over a face of a box lies over two triangles.
struct FlatPatch {
  Vec3 up = Vec3::UnitZ();  ///< unit
  double offset = 0;        ///< plane up . x = offset
  double off_mm = 0;        ///< its faces are nowhere farther from the plane
  struct Rim {
    Vec3 inward = Vec3::Zero();  ///< unit, along the plane
    double offset = 0;
  };
  /// Of every edge of its outline. What has all of them on its inner side lies over the patch: each edge then
  /// turns the same way about it, so the outline winds around it.
  std::vector<Rim> rims;
  /// Up to this height nothing else of the head stands above the patch, except nearer to a rim than rim_mm:
  /// what is over it and not higher is outside. 0: not known.
  double clear_mm = 0, rim_mm = 0;

  /// How far inside the nearest rim a point is; negative outside.
  [[nodiscard]] double inside_mm(const Vec3& x) const;
  /// Above the plane; negative below.
  [[nodiscard]] double height_mm(const Vec3& x) const { return up.dot(x) - offset; }
};

struct FlatPatches {
  std::vector<FlatPatch> patches;
  std::vector<std::uint32_t> patch_of;  ///< by triangle
  std::vector<FlatPatch> faces;         ///< each triangle alone: where a patch has bays, its middle may hide
};

/// Requires a closed surface. Faces whose patch has too many edges are patches of their own. Cost O(n log n).
[[nodiscard]] FlatPatches find_flat_patches(const IndexedMesh& mesh);

/// Fills clear_mm of all patches and faces; it is at most the patch's size.
/// Cost     a search of the tree for each.
void measure_clear_above(const Surface& surface, FlatPatches& flat);

}  // namespace gouge

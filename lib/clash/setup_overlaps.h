#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "lib/clash/clash.h"
#include "lib/mesh/indexed_mesh.h"

namespace gouge {

/// A fixture that penetrates a part, or that may.
struct SetupOverlap {
  std::size_t fixture = 0, part = 0;
  Clash clash;  ///< of the part (A) and the fixture (B): penetrating or not certified
};

/// Every fixture against every part, all in the same coordinates, in that order. `is_left_out`: by fixture.
///
/// A side that the nearest facet of a point shows is confirmed by the winding number before a fixture is said to
/// penetrate, since these meshes may cross themselves; where the two contradict each other it is not certified.
/// Cost  nothing for bodies whose bounding boxes have no more than the tolerance in common; else an index over each
///       mesh, once, and a search (body_depth.h).
[[nodiscard]] std::vector<SetupOverlap> find_setup_overlaps(std::span<const IndexedMesh> parts,
                                                            std::span<const IndexedMesh> fixtures,
                                                            const std::vector<bool>& is_left_out,
                                                            const ClashOptions& options);

}  // namespace gouge

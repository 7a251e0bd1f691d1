#pragma once

#include <cstddef>
#include <vector>

#include "lib/check/prepared_scene.h"
#include "lib/clash/clash.h"

namespace gouge {

/// A fixture that penetrates a part, or that may.
struct SetupOverlap {
  std::size_t fixture = 0, part = 0;
  Clash clash;  ///< of the part (A) and the fixture (B): penetrating or not certified
};

/// Every fixture of a scene against every part, in that order. `is_left_out`: by fixture.
///
/// Requires scene.is_within_reach.
/// Cost  nothing for bodies whose bounding boxes have no more than the tolerance in common; else the surfaces of the
///       scene and a search (body_depth.h).
[[nodiscard]] std::vector<SetupOverlap> find_setup_overlaps(const PreparedScene& scene,
                                                            const std::vector<bool>& is_left_out,
                                                            const ClashOptions& options);

}  // namespace gouge

#pragma once

#include <optional>

#include "lib/clash/clash.h"
#include "lib/penetration/correction.h"

namespace gouge {

/// A shift of B that takes it out of A, proved by find_clash at the shifted position.
struct FreeShift {
  Vec3 shift = Vec3::Zero();            ///< mm, coordinates of A
  bool is_weighted = true;              ///< by the weighted correction; else as far as the bounding boxes are apart
  std::size_t iterations = 0;           ///< of the weighted correction
  ClashState state = ClashState::free;  ///< proved there: free or touching
};

/// Returns the shorter of two shifts; it is not the shortest of all. One is the sum of weighted corrections (thesis
/// 5.3), applied until find_clash proves the bodies free or touching. The other is the shortest shift along a
/// coordinate axis that takes the bounding boxes apart.
///
/// `found`: the clash at rest.
/// Cost     An index with volumes that carry depth over each body, then a search of the points of each for every
///          iteration.
[[nodiscard]] FreeShift find_free_shift(const ClashBody& a, const ClashBody& b, const Clash& found,
                                        const ClashOptions& options);

}  // namespace gouge

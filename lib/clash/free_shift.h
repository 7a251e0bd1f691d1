#pragma once

#include <optional>

#include "lib/clash/clash.h"
#include "lib/penetration/correction.h"

namespace gouge {

/// A shift of B that takes it out of A, proved by find_clash at the shifted position.
struct FreeShift {
  Vec3 shift = Vec3::Zero();            ///< mm, coordinates of A
  bool is_weighted = true;              ///< true: result of the weighted correction; false: shift that takes the
                                        ///< bounding boxes apart
  std::size_t iterations = 0;           ///< iterations of the weighted correction
  ClashState state = ClashState::free;  ///< proved state after the shift: free or touching
};

/// Returns the shorter of two shifts; a shorter one may exist. One is the sum of weighted corrections (thesis 5.3),
/// applied until find_clash proves the bodies free or touching. The other is the shortest shift along a coordinate axis
/// that takes the bounding boxes apart.
///
/// `found` is the clash without a shift.
/// Cost     An index with depth volumes over each body, and for every iteration a search of the points of both.
[[nodiscard]] FreeShift find_free_shift(const ClashBody& a, const ClashBody& b, const Clash& found,
                                        const ClashOptions& options);

}  // namespace gouge

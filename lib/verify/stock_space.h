#pragma once

#include <vector>

#include "lib/verify/claimed_stock.h"
#include "lib/verify/space_block.h"
#include "lib/verify/triangle_order.h"

namespace gouge {

/// The space that a stock takes before all cuts, for proofs that blocks are beside it.
class StockSpace {
 public:
  /// `stock` must outlive it. Cost: as for a TriangleOrder of each of its meshes.
  explicit StockSpace(const ClaimedStock& stock);

  /// Returns the box that contains all points that are deeper in the stock than the resolution. Empty: low is above high.
  [[nodiscard]] const Vec3& low() const { return low_; }
  [[nodiscard]] const Vec3& high() const { return high_; }

  /// Proves that no point of a block is deeper in the stock than the resolution. `may_be_outside` becomes false if every
  /// part of the block would have the answer no. Requires RoundsUpward.
  /// Cost: O(log n) for n triangles; O(n) where none of them is in the block.
  [[nodiscard]] bool is_beside(const SpaceBlock& block, bool& may_be_outside) const;

 private:
  const ClaimedStock& stock_;
  std::vector<TriangleOrder> surfaces_;  // one for each solid
  Vec3 low_ = Vec3::Zero(), high_ = Vec3::Zero();
};

}  // namespace gouge

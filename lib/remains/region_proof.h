#pragma once

#include <cstddef>

#include "lib/remains/stock_side.h"

namespace gouge {

/// Proves that regions are on a side, by parts if necessary. It gives up where the middle of a part is not.
class RegionProof {
 public:
  /// Widened: material between cuts that is thinner than twice the resolution counts as removed.
  enum class Kind { exact, widened };
  RegionProof(const StockSide& side, double inset_mm, Kind kind) : side_(side), inset_mm_(inset_mm), kind_(kind) {}

  /// A region is halved at most this often, one part after the other.
  static constexpr int kHalvings = 9;
  [[nodiscard]] bool holds(const HullRegion& region, int halvings = kHalvings);

 private:
  const StockSide& side_;
  double inset_mm_;
  Kind kind_;
  CutMove hint_;
};

}  // namespace gouge

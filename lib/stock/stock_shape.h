#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "lib/base/result.h"
#include "lib/stock/stock_solid.h"
#include "lib/surface/surface.h"

namespace gouge {

/// The shape of the material before the path, as a user states it.
struct StockShape {
  enum class Kind : std::uint8_t {
    box,   ///< the box about the parts, larger by the allowance on each side
    part,  ///< the parts, moved out by the allowance
    file   ///< meshes of their own
  };
  Kind kind = Kind::file;
  double allowance_mm = 0;
};

/// A stock with the words that describe it in reports.
struct DescribedStock {
  StockSolid solid;
  std::string description;
};

/// Makes the stock of a shape from the parts, or from meshes of its own with that name. All meshes must outlive it.
/// Errors: stock-open-mesh.
[[nodiscard]] Result<DescribedStock> make_stock(const StockShape& shape, std::span<const IndexedMesh> meshes,
                                                const std::string& name);

}  // namespace gouge

#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "lib/check/check_move.h"
#include "lib/path/toolpath.h"

namespace gouge {

/// How near a tool comes to the parts while it cuts. What belongs to a part cuts along it, so this tells at a glance
/// whether part and path lie in one place. It is looked at, not certified.
struct Closeness {
  static constexpr double kFar_mm = 20;  ///< what is farther away is not measured

  std::size_t cuts = 0;       ///< moves with a tool that are neither rapid nor left unchecked
  std::size_t positions = 0;  ///< how many of their ends were looked at, spread evenly over the path
  /// Distance of the tool, with its stock to leave, from the parts: 0 where it touches; none: farther than kFar_mm.
  std::optional<double> nearest_mm;
  std::optional<double> median_mm;  ///< half of the positions are as near
};

/// Shape    as check_path. Nothing where there is no part or no cut.
/// Ensures  the same result at any number of threads; distances to a hundredth of a millimetre.
/// Cost     a search at 400 positions at most.
[[nodiscard]] std::optional<Closeness> measure_closeness(const Toolpath& toolpath,
                                                         const std::vector<const ToolForms*>& tools,
                                                         const PreparedScene& scene, unsigned threads);

}  // namespace gouge

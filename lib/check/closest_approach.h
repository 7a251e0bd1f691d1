#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "lib/check/prepared_scene.h"
#include "lib/check/verdict.h"
#include "lib/path/toolpath.h"

namespace gouge {

/// Observed closest approach of the tool to the parts in cuts. A path that belongs to a part cuts along it, so this
/// shows at a glance whether part and path coincide. Both distances are bounds from above: the tool comes as near, and
/// may be closer between the sampled positions.
struct ClosestApproach {
  static constexpr double kFar_mm = 20;  ///< greater distances are not measured

  std::size_t cuts = 0;       ///< moves with a tool that are neither rapid nor left unchecked
  std::size_t positions = 0;  ///< how many of their ends were examined: one out of each of as many equal shares
  /// The minimum distance of the tool, with its stock to leave, from the parts. It is taken at these positions, and in
  /// moves that the check found to touch or to be near. 0 where the tool touches; none where no distance is within
  /// kFar_mm.
  std::optional<double> nearest_mm;
  std::optional<double> median_mm;  ///< half of the positions are as near
  double apart_mm = 0;  ///< proved: at none of the positions examined is the tool nearer; nothing of the others
};

/// Returns "37 cutting positions" or "400 cutting positions examined (of 2425)".
[[nodiscard]] std::string positions_examined(const ClosestApproach& closest_approach);

/// Shape    As check_path, `verdicts` its result on the same path. Nothing where there is no part or no cut.
/// Ensures  The same result at any number of threads; distances to a hundredth of a millimetre.
/// Cost     A search at 400 positions at most.
[[nodiscard]] std::optional<ClosestApproach> measure_closest_approach(const Toolpath& toolpath,
                                                                      const std::vector<const ToolVariants*>& tools,
                                                                      const PreparedScene& scene,
                                                                      const MoveVerdicts& verdicts, unsigned threads);

}  // namespace gouge

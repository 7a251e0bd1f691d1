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
/// shows at a glance whether path and part coincide. Both distances are upper bounds: the tool reaches them, and may
/// come closer between the sampled positions.
struct ClosestApproach {
  static constexpr double kFar_mm = 20;             ///< greater distances are not measured
  static constexpr double kApart_mm = 2;            ///< a tool that is never nearer hardly cuts the part
  static constexpr std::size_t kMinPositions = 10;  ///< fewer positions do not contradict the placement of the part

  std::size_t cuts = 0;       ///< number of moves with a tool that are neither rapid nor unchecked
  std::size_t positions = 0;  ///< number of cuts whose ends were examined: one from each of as many equal shares
  /// Minimum distance of the tool, including its stock to leave, from the parts. It covers the examined positions, and
  /// moves that the check found to touch or to be near. If all of these are apart, it also covers the examined cuts
  /// whose tool axis stays, along their whole path. 0 if the tool touches; none if no distance is within kFar_mm.
  std::optional<double> nearest_mm;
  std::optional<double> median_mm;  ///< at half of the positions the distance is at most this
  double apart_mm = 0;  ///< proved minimum distance at the examined positions; the other positions may be closer

  /// Returns whether the tool is farther than kApart_mm from the part at all places that `nearest_mm` covers.
  [[nodiscard]] bool is_apart() const { return positions > 0 && nearest_mm.value_or(kFar_mm) > kApart_mm; }
};

/// Returns a text such as "at none of 37 cutting positions is the tool nearer than 4.0 mm to the part". If the
/// tool comes nearer between these positions, the text states that distance too.
[[nodiscard]] std::string apart_text(const ClosestApproach& closest_approach);

/// Returns a text such as "37 cutting positions" or "400 cutting positions examined (of 2425)".
[[nodiscard]] std::string positions_examined(const ClosestApproach& closest_approach);

/// Measures the closest approach of the tool to the parts.
///
/// Shape    The same as check_path; `verdicts` is its result on the same path. Returns nothing if there is no part or
///          no cut.
/// Ensures  The result is the same at any number of threads. Distances are accurate to a hundredth of a millimetre.
/// Cost     A search at 400 positions at most, and along the cuts to them if all are apart.
[[nodiscard]] std::optional<ClosestApproach> measure_closest_approach(const Toolpath& toolpath,
                                                                      const std::vector<const ToolVariants*>& tools,
                                                                      const PreparedScene& scene,
                                                                      const MoveVerdicts& verdicts, unsigned threads);

}  // namespace gouge

#pragma once

#include <optional>
#include <vector>

#include "lib/base/tolerance.h"
#include "lib/certify/motion_checker.h"
#include "lib/correct/reworked_path.h"

// Arcs and splines that must change first become straight moves. Their chords are so close to the curve that they share
// its verdict. Each chord is corrected like any other straight move. A stretch that needs no change then becomes the
// original curve again.

namespace gouge {

/// Maximum distance of chords from their curve, as a share of the tolerance. Every chord is checked, so they need not
/// be finer than the aim of a correction.
inline constexpr double kChordShare = 0.5;
inline constexpr double kMinChordError_mm = Tolerance::kCorrection_mm;  ///< limit given by the digits of the files

/// Replaces curves by chords. Returns nothing if no correction of `result` has to change a curve. `others` marks moves
/// that must become straight whatever their verdict; it has one entry for each move, or is empty.
[[nodiscard]] std::optional<ReworkedPath> straighten(const Toolpath& path, const CheckResult& result,
                                                     const std::vector<const ToolVariants*>& tools,
                                                     const MotionChecker& checker,
                                                     const std::vector<bool>& others = {});

}  // namespace gouge

#pragma once

#include <optional>
#include <vector>

#include "lib/base/tolerance.h"
#include "lib/certify/motion_checker.h"
#include "lib/correct/reworked_path.h"

// Arcs and splines that must change become straight moves first. Their chords are so close to the curve that they share
// its verdict, and each is corrected like any other straight move. A stretch that needs no change then stays the curve
// it was.

namespace gouge {

/// Chords stay within this share of the tolerance of their curve. Every chord is checked, so they need be no finer than
/// the aim of a correction.
inline constexpr double kChordShare = 0.5;
inline constexpr double kMinChordError_mm = Tolerance::kCorrection_mm;  ///< of the digits of the files

/// Returns nothing where no correction of `result` has to change a curve. Moves in `others`, one entry a move or none,
/// must be straight whatever their verdict.
[[nodiscard]] std::optional<ReworkedPath> straighten(const Toolpath& path, const CheckResult& result,
                                                     const std::vector<const ToolVariants*>& tools,
                                                     const MotionChecker& checker,
                                                     const std::vector<bool>& others = {});

}  // namespace gouge

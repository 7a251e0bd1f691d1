#pragma once

#include <optional>
#include <vector>

#include "lib/certify/motion_checker.h"
#include "lib/correct/correct_path.h"

// Arcs and splines that must change become straight moves first: chords so close to the curve that they share
// its verdict, each corrected like any other straight move. What then needs no change stays the curve it was.

namespace gouge {

/// A path whose curves that gouge, or touch a gouging move, are chords.
struct StraightenedPath {
  Toolpath path;                    ///< moves, arcs and splines only; no source
  std::vector<std::size_t> origin;  ///< of each of its moves: which move of the path as it was
  CheckResult result;               ///< verdicts of its moves; no events
};

/// Chords stay within this share of the tolerance of their curve: every chord is checked, so they need be no finer than
/// what a correction aims at.
inline constexpr double kChordShare = 0.5;
inline constexpr double kLeastChordError_mm = 2e-4;  ///< of the digits of the files

/// Nothing where no correction of `result` has to change a curve.
[[nodiscard]] std::optional<StraightenedPath> straighten(const Toolpath& path, const CheckResult& result,
                                                         const std::vector<const ToolVariants*>& tools,
                                                         const MotionChecker& checker);

/// The changes of a straightened path as changes of the path as it was.
[[nodiscard]] Correction restore_curves(const StraightenedPath& straightened, const Toolpath& path,
                                        const CheckResult& result, Correction correction);

}  // namespace gouge

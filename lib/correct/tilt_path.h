#pragma once

#include <optional>
#include <vector>

#include "lib/correct/reworked_path.h"
#include "lib/tilt/plan_tilts.h"

namespace gouge {

/// Returns the moves with gouges of bodies whose strategy is `wanted`, one entry for each move. Only leaving it out
/// frees a buried move, so it counts for that strategy.
[[nodiscard]] std::vector<bool> moves_to(Strategy wanted, const Toolpath& path, const CheckResult& result,
                                         const BodyStrategies& strategies);

/// A path whose runs are to be tilted, and the settings. All objects must outlive the call.
struct TiltRequest {
  const Toolpath& path;
  const CheckResult& result;
  const std::vector<const ToolVariants*>& tools;
  const MotionChecker& checker;
  const BodyStrategies& strategies;
  const TiltOptions& options;
  bool may_tilt = true;  ///< false: curves become chords as necessary, but no run is tilted
};

struct TiltProposal {
  std::optional<ReworkedPath> straight;  ///< path with chords for curves; none: no curve must change
  std::vector<bool> is_wanted;           ///< moves of the straight path to tilt; empty: none
  TiltPlan plan;                         ///< tilts of the straight path

  /// Returns the move of the path of which move `i` of the plan is a piece.
  [[nodiscard]] std::size_t origin_of(std::size_t i) const { return straight ? straight->origin[i] : i; }
};

/// Returns tilts for all gouges of bodies whose strategy is to tilt.
[[nodiscard]] TiltProposal propose_tilts(const TiltRequest& request, const ProgressCall& progress);

/// Returns a path with the positions of a plan. The `plan` refers to `straight` or, if that is missing, to `path`.
/// Moves of the result are pieces of the moves of `path`.
[[nodiscard]] ReworkedPath tilt_path(const Toolpath& path, const CheckResult& result,
                                     const std::optional<ReworkedPath>& straight, const TiltPlan& plan,
                                     const std::vector<const ToolVariants*>& tools, const MotionChecker& checker);

}  // namespace gouge

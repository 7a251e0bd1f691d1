#pragma once

#include <optional>
#include <vector>

#include "lib/correct/reworked_path.h"
#include "lib/tilt/plan_tilts.h"

namespace gouge {

/// Returns the moves with gouges of bodies whose strategy is `wanted`, one entry a move. A buried move is freed only by
/// leaving it out, and counts for that strategy.
[[nodiscard]] std::vector<bool> moves_to(Strategy wanted, const Toolpath& path, const CheckResult& result,
                                         const BodyStrategies& strategies);

/// A path whose runs are to be tilted, and how. All must outlive the call.
struct TiltRequest {
  const Toolpath& path;
  const CheckResult& result;
  const std::vector<const ToolVariants*>& tools;
  const MotionChecker& checker;
  const BodyStrategies& strategies;
  const TiltOptions& options;
  bool may_tilt = true;  ///< false: curves become chords as far as they must, and what would be tilted has no run
};

struct TiltProposal {
  std::optional<ReworkedPath> straight;  ///< curves as chords; none: it has none that must change
  std::vector<bool> is_wanted;           ///< moves of the straight path to tilt; empty: none
  TiltPlan plan;                         ///< of the straight path

  /// Maps a move of the plan: which move of the path it is a piece of.
  [[nodiscard]] std::size_t origin_of(std::size_t i) const { return straight ? straight->origin[i] : i; }
};

/// Returns tilts for all gouges of bodies whose strategy is to tilt.
[[nodiscard]] TiltProposal propose_tilts(const TiltRequest& request, const ProgressCall& progress);

/// Returns a path with the positions of a plan. The `plan` is of `straight`, or of `path` where there is none. Moves of
/// the result are pieces of the moves of `path`.
[[nodiscard]] ReworkedPath tilt_path(const Toolpath& path, const CheckResult& result,
                                     const std::optional<ReworkedPath>& straight, const TiltPlan& plan,
                                     const std::vector<const ToolVariants*>& tools, const MotionChecker& checker);

}  // namespace gouge

#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "lib/base/result.h"
#include "lib/certify/check.h"

// Finds the stick-out of a tool at which shank, holder and heads are free. This cure does not change the path or the
// cut surface.

namespace gouge {

/// The non-cutting bodies of a tool with a longer stick-out, and the heads above it.
struct LongerTool {
  ToolVariants bodies;  ///< only shank and holder; without elements if the tool has neither
  std::vector<HeadBody> heads;
};
using MakeLongerTool = std::function<Result<LongerTool>(std::size_t tool, double longer_mm)>;

struct StickoutOptions {
  double step_mm = 1;          ///< lengths are multiples of this
  double max_longer_mm = 200;  ///< maximum lengthening that is tried
};

/// The stick-out that some moves of a tool need.
struct StickoutNeed {
  std::optional<double> stickout_mm;  ///< the present one, or the smallest multiple of the step that was found; none:
                                      ///< not found
  /// If the present stick-out is not enough: the first move that is not free one step below, or at the maximum. It
  /// comes with the obstructing body and its state (gouge, buried, or not certified).
  std::size_t move = kNone;
  Body body = Body::holder;
  MoveState state = MoveState::gouge;

  [[nodiscard]] bool is_enough() const { return stickout_mm && move == kNone; }
};

struct OperationStickout {
  std::size_t operation = kNone;  ///< index into Toolpath::operations; kNone: moves before the first
  StickoutNeed need;
};

struct ToolStickout {
  std::size_t tool = 0;  ///< index into Toolpath::tools
  double now_mm = 0;
  StickoutNeed all;                           ///< for all moves of the tool
  std::vector<OperationStickout> operations;  ///< for each operation, in path order
};

/// Finds, for each tool with a stick-out, the smallest one that frees its moves of gouges by shank, holder and heads.
/// The cutter is not examined.
///
/// Requires `result` from check() with the same path and setup. `now_mm` has one value for each of Toolpath::tools,
/// none for a tool to leave out.
/// Ensures  (1) With that stick-out check() of the bodies finds no gouge in any of the moves. Buried or uncertain moves
///          remain only if they are so with the present stick-out. (2) One step below, the named move is not proved
///          free. (3) For a tool that gets wider upwards, no shorter stick-out suffices: a longer tool occupies less
///          space. (4) The result is the same at any number of threads.
/// Errors   Those of `make`.
/// Cost     For each tool, a check of its moves at the present length and at each reported length. For moves that are
///          not free, additionally about twice the logarithm of the number of steps.
[[nodiscard]] Result<std::vector<ToolStickout>> find_stickouts(const Toolpath& path, const CheckResult& result,
                                                               const CheckSetup& setup,
                                                               const std::vector<std::optional<double>>& now_mm,
                                                               const MakeLongerTool& make,
                                                               const StickoutOptions& options,
                                                               const ProgressCall& progress = {});

}  // namespace gouge

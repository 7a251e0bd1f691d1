#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "lib/base/result.h"
#include "lib/certify/check.h"

// Finds the stick-out of a tool at which shank, holder and heads are free. This cure leaves the path and the cut
// surface as they are.

namespace gouge {

/// The non-cutting bodies of a tool with a longer stick-out, and the heads above it.
struct LongerTool {
  ToolVariants bodies;  ///< shank and holder alone; no elements: it has none
  std::vector<HeadBody> heads;
};
using MakeLongerTool = std::function<Result<LongerTool>(std::size_t tool, double longer_mm)>;

struct StickoutOptions {
  double step_mm = 1;          ///< lengths are multiples of this
  double max_longer_mm = 200;  ///< none is sought beyond
};

/// Stick-out that some moves of a tool need.
struct StickoutNeed {
  std::optional<double> stickout_mm;  ///< as it is, or the least multiple of the step found; none: none up to the most
  /// Where the stick-out is not enough as it is: the first move that is not free one step below, or at the maximum.
  /// Beside it the body that is in the way, and how: a gouge, buried, or not certified to be neither.
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
  StickoutNeed all;                           ///< of all its moves
  std::vector<OperationStickout> operations;  ///< by operation, in path order
};

/// Finds for each tool that has a stick-out the least one that frees its moves of gouges by shank, holder and heads.
/// The cutter is not examined.
///
/// Requires `result` from check() with the same path and setup. There is one `now_mm` per Toolpath::tools, none for
/// tools to leave out.
/// Ensures  (1) With that stick-out check() of the bodies finds no gouge in any of the moves. Buried or uncertain moves
///          remain only where they are so with the present stick-out. (2) One step below, the named move is not proved
///          free. (3) For a tool that gets wider upwards no shorter one would do: longer, it holds less space. (4) The
///          same at any number of threads.
/// Errors   Those of `make`.
/// Cost     For each tool a check of its moves as they are and at each length reported. For moves that are not free
///          also about twice the logarithm of the steps.
[[nodiscard]] Result<std::vector<ToolStickout>> find_stickouts(const Toolpath& path, const CheckResult& result,
                                                               const CheckSetup& setup,
                                                               const std::vector<std::optional<double>>& now_mm,
                                                               const MakeLongerTool& make,
                                                               const StickoutOptions& options,
                                                               const ProgressCall& progress = {});

}  // namespace gouge

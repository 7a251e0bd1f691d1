#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "lib/base/result.h"
#include "lib/certify/check.h"

// Finds the stick-out of a tool at which shank, holder and heads are free: the cure that leaves the
// path and the cut surface as they are.

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
  /// Where the stick-out is not enough as it is: the first move that is not free one step below, or at the most, and
  /// what is in the way there and how: a gouge, buried, or not certified to be neither.
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

/// For each tool that has a stick-out the least that frees its moves of gouges by shank, holder and heads. What the
/// cutter does is not examined.
///
/// `result` from check() with the same path and setup; `now_mm` one per Toolpath::tools, none for those to leave out.
/// Ensures  With that stick-out check() of the bodies finds no gouge in any of the moves, buried or uncertain ones but
///          where they are as it stands; one step below, the named move is not proved free. Of a tool that gets wider
///          upwards no shorter one would do: longer, it holds less space. The same at any number of threads.
/// Errors   Those of `make`.
/// Cost     For each tool a check of its moves as they are and at each length reported, and of those that are not free
///          about twice the logarithm of the steps.
[[nodiscard]] Result<std::vector<ToolStickout>> find_stickouts(const Toolpath& path, const CheckResult& result,
                                                               const CheckSetup& setup,
                                                               const std::vector<std::optional<double>>& now_mm,
                                                               const MakeLongerTool& make,
                                                               const StickoutOptions& options,
                                                               const ProgressCall& progress = {});

}  // namespace gouge

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lib/check/check_move.h"
#include "lib/path/toolpath.h"

namespace gouge {

/// One of the usual mistakes that bring path and part out of step, and how well they would fit without it.
struct Explanation {
  std::string without;  ///< "with J negated", "with the part in inches instead of mm"
  double share = 0;     ///< of the positions looked at, of those that then touch the part without cutting into it
};

/// A path, or one operation of it, that plainly does not belong to the part as it lies.
struct Misfit {
  std::size_t first_move = 0;  ///< of the operation
  std::size_t positions = 0;   ///< cutting positions looked at ...
  std::size_t deep = 0;        ///< ... of which this many are deeper than the cutter's radius, or inside the solid
  double share_touching = 0;   ///< of those that touch the part without cutting into it
  std::optional<Explanation> explanation;  ///< none of the usual mistakes: nothing
};

/// The first operation, by tool, of which more than half of the cutting positions have the surface as deep in the tool as
/// its cutter's radius, or the middle of the cutter inside a solid; or of which a tenth have, and one of the usual mistakes
/// explains it. A shallow undercut, however uniform, is none.
///
/// Shape    as check_path.
/// Ensures  the same answer at any number of threads. An operation of fewer than kFewestPositions is not judged.
/// Cost     a search at kMostPositions positions at most of each operation; for the one that does not fit, the same for
///          each mistake tried, and the trees of the part in two other units.
[[nodiscard]] std::optional<Misfit> find_misfit(const Toolpath& path, const std::vector<const ToolForms*>& tools,
                                                const PreparedScene& scene, const CheckOptions& options);

}  // namespace gouge

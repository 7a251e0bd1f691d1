#pragma once

#include <optional>
#include <vector>

#include "lib/correct/correct_path.h"
#include "lib/correct/motion_checker.h"

// An arc that must change stays an arc where one can be found: the same circle elsewhere, or about a centre
// that its new ends ask for.

namespace gouge {

/// An arc whose ends go elsewhere.
struct ArcTask {
  PathArc arc;
  Pose start, end;          ///< as they are
  Pose new_start, new_end;  ///< with the same tool axes
  MoveKind kind = MoveKind::arc;
  const ToolForms* tool = nullptr;
};

/// The arc from `new_start` to `new_end` that changes least and is clean.
///
/// Requires the end poses of an arc of one turn at most.
/// Ensures  (1) The vector and the way round are the same; both ends are equally far from its centre line,
/// and as high above each
///          other as they were, to a fifth of the tolerance. A full circle stays one.
///          (2) It is clean to four fifths of the tolerance, which leaves room for the digits of the file,
///          over its whole motion (check_move). (3) Where it leaves the arc as it was by more than the
///          tolerance, nine tenths of that were too deep: no part that fits is given up for another. Sixteen
///          places of it are shifted as why_not_shift allows.
/// Tried    the centre shifted with the ends; the centre line kept, with another radius; each moved to where
/// both ends are
///          equally far.
[[nodiscard]] std::optional<PathArc> shift_arc(const ArcTask& task, const MotionChecker& checker);

/// Lets arcs of `path` that `correction` makes straight stay arcs where shift_arc finds one for the ends they
/// got. Only arcs that `can_rewrite` (one entry a move) are looked at. Positions and all other moves stay as
/// proposed.
void keep_arcs(const Toolpath& path, const std::vector<bool>& can_rewrite,
               const std::vector<const ToolForms*>& tools, const MotionChecker& checker,
               Correction& correction);

}  // namespace gouge

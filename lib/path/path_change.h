#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "lib/geom/pose.h"
#include "lib/path/curve.h"

namespace gouge {

/// A correction of one move, with poses in mm and part coordinates, as in the Toolpath.
///
/// At most one of `is_straightened`, `new_arc` and `hole_shift_mm` is set; `hole_shift_mm` excludes all other members.
struct PathChange {
  std::size_t move = 0;
  std::optional<Pose> new_end;
  std::vector<Pose> inserted_before;  ///< positions to visit, in this order, before the move's end
  /// True if an arc or spline becomes straight moves through `inserted_before` to the end.
  bool is_straightened = false;
  /// The arc stays an arc, about another axis line, to the move's (new) end. It begins at the last of
  /// `inserted_before`, which straight lines reach. Without inserted positions it begins at the end of the move before,
  /// after that move's own change. Both ends lie on the circle to 0.01 mm; those of a full circle are the same
  /// position, digit for digit. The sign of the sweep about the axis is its direction, as in Toolpath::arcs.
  std::optional<PathArc> new_arc = std::nullopt;
  /// Shift of the drilled hole whose first move this is. It applies to the programmed position and to all heights that
  /// the cycle counts from there. The height to which the cycle rises from the position before the hole stays. So a
  /// hole may get a step more or less than before. When read again, its moves are those of the same statement.
  std::optional<Vec3> hole_shift_mm = std::nullopt;
  /// Arcs to each of `inserted_before`, with ends as for new_arc; none: a straight line. The list has one entry for
  /// each, or is empty: all are straight. It is only for an arc, together with `new_arc` or `is_straightened`, which
  /// state how the move's own end is reached.
  std::vector<std::optional<PathArc>> inserted_arcs = {};
  /// For a feed, or a curve that becomes straight: which of `inserted_before` and the move's own end are reached at
  /// rapid. It has one entry for each and one for the end, or is empty: none is.
  std::vector<bool> at_rapid = {};

  /// Returns whether the k-th of `inserted_before`, or for k = their number the end of the move, is reached at rapid.
  [[nodiscard]] bool is_at_rapid(std::size_t k) const { return k < at_rapid.size() && at_rapid[k]; }
  [[nodiscard]] bool is_end_at_rapid() const { return is_at_rapid(inserted_before.size()); }

  /// Returns whether some motion of the changed move is an arc that this change states.
  [[nodiscard]] bool has_arc() const {
    return new_arc ||
           std::any_of(inserted_arcs.begin(), inserted_arcs.end(), [](const auto& arc) { return arc.has_value(); });
  }
};

/// The moves that a correction can rewrite within the statements of a file. Each list has one entry for each move of
/// the path, or is empty if nothing can be rewritten.
struct RewritableMoves {
  std::vector<bool> arc;    ///< PathChange::new_arc can be written; otherwise the arc can only be straightened
  std::vector<bool> split;  ///< PathChange::inserted_arcs can be written too: the arc can become several
  bool has_axes = false;    ///< the file states tool axes
  bool has_rapids = false;  ///< PathChange::at_rapid can be written: the dialect has a rapid for a single motion
  std::vector<bool> hole;   ///< PathChange::hole_shift_mm can be written; true only for the first move of a hole
};

}  // namespace gouge

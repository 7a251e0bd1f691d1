#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "lib/geom/pose.h"
#include "lib/path/curve.h"

namespace gouge {

/// A correction of one move. Poses in mm and part coordinates, as in the Toolpath.
///
/// At most one of `is_straightened`, `new_arc` and `hole_shift_mm`; the last stands alone.
struct PathChange {
  std::size_t move = 0;
  std::optional<Pose> new_end;
  std::vector<Pose> inserted_before;  ///< positions to visit, in this order, before the move's end
  /// An arc or spline becomes straight moves through `inserted_before` to the end.
  bool is_straightened = false;
  /// The arc stays an arc, about another axis line, to the move's (new) end. It begins at the last of
  /// `inserted_before`, which are reached on straight lines, or else where the move before it ends after its
  /// own change. Both ends lie on the circle to 0.01 mm; those of a full circle are the same position, digit for
  /// digit. The sign of the sweep about the axis is its direction, as in Toolpath::arcs.
  std::optional<PathArc> new_arc = std::nullopt;
  /// The drilled hole whose first move this is goes elsewhere: its programmed position, and with it all heights that
  /// the cycle counts from there. The height to which the cycle rises from the position before the hole stays. So a
  /// hole may get a step more or less than it had. Read again, its moves are those of the same statement.
  std::optional<Vec3> hole_shift_mm = std::nullopt;
  /// Arcs to each of `inserted_before`, with ends as for new_arc; none: straight. One
  /// entry each, or none at all: all straight. Only of an arc, beside `new_arc` or `is_straightened`, which state how
  /// the end of the move itself is reached.
  std::vector<std::optional<PathArc>> inserted_arcs = {};
  /// For a feed, or a curve that becomes straight: which of `inserted_before`, and whether its own end, is
  /// reached at rapid. One entry each and one for the end, or none at all: none is.
  std::vector<bool> at_rapid = {};

  /// Returns whether the k-th of `inserted_before`, or the end of the move behind them, becomes a rapid.
  [[nodiscard]] bool is_at_rapid(std::size_t k) const { return k < at_rapid.size() && at_rapid[k]; }
  [[nodiscard]] bool is_end_at_rapid() const { return is_at_rapid(inserted_before.size()); }

  /// Returns true where some piece of what the move becomes is an arc of the change's own.
  [[nodiscard]] bool has_arc() const {
    return new_arc ||
           std::any_of(inserted_arcs.begin(), inserted_arcs.end(), [](const auto& arc) { return arc.has_value(); });
  }
};

/// The moves that a correction can rewrite within the statements of a file. There is one entry a move of the path, or
/// none at all where nothing can be rewritten.
struct RewritableMoves {
  std::vector<bool> arc;    ///< PathChange::new_arc can be written; elsewhere the arc can only be straightened
  std::vector<bool> split;  ///< and PathChange::inserted_arcs: the arc can become several
  bool has_axes = false;    ///< the file states tool axes
  bool has_rapids = false;  ///< PathChange::at_rapid can be written: the dialect has a rapid for one motion
  std::vector<bool> hole;   ///< PathChange::hole_shift_mm can be written; true for the first move of a hole alone
};

}  // namespace gouge

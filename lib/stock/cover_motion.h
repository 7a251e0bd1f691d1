#pragma once

#include <vector>

#include "lib/base/tolerance.h"
#include "lib/motion/motion.h"
#include "lib/stock/convex_pieces.h"
#include "lib/stock/motion_tree.h"
#include "lib/stock/tool_piece.h"

// Tests whether one motion of one cutter contains a piece of space. A test that fails proves nothing.

namespace gouge {

/// A straight motion with a fixed axis, over [0, 1].
struct StraightCut {
  Vec3 from = Vec3::Zero(), by = Vec3::Zero(), axis = Vec3::UnitZ();
};

/// Room between a piece of space and the cutter, from the slack of the piece and the resolution.
struct CoverMargin {
  double slack_mm = 0, resolution_mm = 0;
  /// Returns the largest value of a convex piece at a corner for which the piece of space, moved out by the slack, is in
  /// the convex piece, moved out by the resolution.
  [[nodiscard]] double largest_value(const ConvexPiece& piece) const {
    const double room = resolution_mm - slack_mm;
    return (room > 0 ? piece.growth * room : room) - Tolerance::kRounding_mm;
  }
};

/// Returns whether the piece is in the sweep of one of the convex pieces, with that margin, during its whole interval. The
/// sweep of a convex solid along a straight line is convex, so it contains the hull of discs that it contains.
[[nodiscard]] bool is_covered_by(const StraightCut& cut, const std::vector<ConvexPiece>& pieces,
                                 const SweptPiece& piece, const CoverMargin& margin);
/// A time interval of a motion in which its cutter may contain a piece.
struct CutWindow {
  double from = 0, until = 1;
};

/// Returns whether the piece is in one of the convex pieces of a cutter during a window of a motion, with that margin. The
/// cutter is at one instant at the start of the piece's interval and at another one at its end: between them the piece
/// moves straight in the cutter's frame. Where the axis turns, one instant serves for the whole interval.
/// Cost  A few evaluations of a convex piece, at most kMaxCoverInstants for each.
[[nodiscard]] bool is_covered_by(const Motion& motion, const CutWindow& window, const std::vector<ConvexPiece>& pieces,
                                 const SweptPiece& piece, const CoverMargin& margin);

/// Number of instants after which the search for one that contains a piece ends.
inline constexpr std::size_t kMaxCoverInstants = 256;

/// Returns the least distance of a point from the cutter that a search over a span of a motion finds; negative inside.
[[nodiscard]] double nearest_distance_mm(const Motion& motion, const MotionSpan& span, const CompiledTool& cutter,
                                         const Vec3& point);

}  // namespace gouge

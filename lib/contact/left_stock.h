#pragma once

#include <array>
#include <limits>
#include <optional>

#include "lib/contact/cutter_sweep.h"
#include "lib/hierarchy/block_tree.h"
#include "lib/path/toolpath.h"

namespace gouge {

/// Stock that a changed path leaves on the part but the path before it did not leave.
struct LeftStock {
  double thickness_mm = 0;    ///< distance from the point to the nearest cut; at no point is it much more
  bool is_more = false;       ///< it may be more than that: no cut is near, or the search ended early
  bool is_proved = true;      ///< false: no such point was found, but its absence is not proved
  Vec3 point = Vec3::Zero();  ///< a point of the surface
  std::size_t move = kNone;   ///< the motion that finished the point
};

/// Default work: some hundredths of a second of one processor.
inline constexpr std::size_t kUsualStockWork = 320'000;

struct StockLimits {
  double finished_mm = 0;                  ///< surface that is cut to this height above it, or lower, is finished
  double allowed_mm = 0;                   ///< stock within this distance of a cut does not count as left
  double max_mm = 0;                       ///< larger thicknesses are not distinguished
  bool are_solids = false;                 ///< triangles face out of solids: nothing is finished from inside
  std::size_t max_work = kUsualStockWork;  ///< maximum number of bounds and distances; after it, pieces stay undecided
  /// Maximum work on the thickness, after a point with left stock was found.
  std::size_t max_work_once_left = std::numeric_limits<std::size_t>::max();
};

/// The cuts of a path in two parts; a part may be null if it has none.
using SweepsAfter = std::array<const CutterSweep*, 2>;

/// Maximum reported thickness; larger ones are clamped to it.
inline constexpr double kMaxStock_mm = 20;

/// Finds points where `before` finished the surface and no cut of `after` comes as near as allowed. Returns the point
/// with the largest distance from the cuts of `after`.
///
/// Two kinds of points do not count as finished.
/// (1) Points near the border of the region that a cutter reaches: closer than 2 % of its radius, at most 0.1 mm.
/// (2) Points that `before` gouged, deeper than finished surface may be, and points near them. There the cutter cut
/// through the surface. "Near" is the width of the rim of a ball that is hardly deeper (2 sqrt(r finished_mm), at most
/// 0.5 mm).
/// Ensures  (1) If nothing is returned, this is proved for every point of every triangle and every instant. (2) The
///          thickness is true at its point to 0.001 mm. Unless is_more, no thickness elsewhere is larger by more than a
///          tenth plus 0.01 mm.
/// Cost     Limited by the permitted work, on one thread. A finished surface on which nothing is left takes one piece
///          for each area that one pose of the new cutter covers. That is some tenths of a millimetre under a ball, and
///          a footprint under a flat end.
/// Method   docs/method/tilting.md, "What a tilt leaves".
[[nodiscard]] std::optional<LeftStock> find_left_stock(const BlockTree& parts, const CutterSweep& before,
                                                       const SweepsAfter& after, const StockLimits& limits);

}  // namespace gouge

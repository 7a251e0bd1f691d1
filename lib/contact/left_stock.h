#pragma once

#include <array>
#include <limits>
#include <optional>

#include "lib/contact/cutter_sweep.h"
#include "lib/hierarchy/block_tree.h"
#include "lib/path/toolpath.h"

namespace gouge {

/// Stock that a changed path leaves on the part where the path before it did not.
struct LeftStock {
  double thickness_mm = 0;    ///< from the point to the nearest place that is cut; no point is left by much more
  bool is_more = false;       ///< it may be more than that: nothing near is cut, or the search ended before
  bool is_proved = true;      ///< false: no such point was found, but that there is none is not proved
  Vec3 point = Vec3::Zero();  ///< of the surface
  std::size_t move = kNone;   ///< the motion that finished it
};

/// Some tenths of a second of a processor.
inline constexpr std::size_t kUsualStockWork = 1'000'000;

struct StockLimits {
  double finished_mm = 0;                  ///< surface cut to this height above it, or lower, is finished
  double allowed_mm = 0;                   ///< stock no farther from a cut is not left
  double max_mm = 0;                       ///< thicknesses beyond this are not distinguished
  bool are_solids = false;                 ///< triangles face out of solids: nothing is finished from within
  std::size_t max_work = kUsualStockWork;  ///< bounds and distances; pieces not decided by then stay undecided
  /// The same for how much is left, once a point is known that is.
  std::size_t max_work_once_left = std::numeric_limits<std::size_t>::max();
};

/// The cuts of a path, in two parts; null: none.
using SweepsAfter = std::array<const CutterSweep*, 2>;

/// Larger thicknesses are clamped to this value.
inline constexpr double kMaxStock_mm = 20;

/// Finds where `before` finished the surface and no cut of `after` comes as near as allowed. Returns the point farthest
/// from what is cut in `after`.
///
/// Two kinds of points are not counted as finished.
/// (1) Points closer to the border of what a cutter reaches than 2 % of its radius, 0.1 mm at the most.
/// (2) Points that `before` gouged deeper than finished surface may be, and points near them. There the cutter cut
/// through the surface. Near means closer than the rim of a ball is wide that is hardly deeper (2 sqrt(r finished_mm),
/// 0.5 mm at the most).
/// Ensures  (1) Nothing: proved, for every point of every triangle and every instant. (2) The thickness is true of its
///          point to 0.001 mm, and nowhere larger by more than a tenth and 0.01 mm, unless is_more.
/// Cost     Bounded by the work allowed, one thread. A finished surface of which nothing is left takes one piece for
///          what one pose of the new cutter covers. That is some tenths of a millimetre under a ball, a footprint under
///          a flat end.
/// Method   docs/method/tilting.md, "What a tilt leaves".
[[nodiscard]] std::optional<LeftStock> find_left_stock(const BlockTree& parts, const CutterSweep& before,
                                                       const SweepsAfter& after, const StockLimits& limits);

}  // namespace gouge

#include <algorithm>
#include <cmath>

#include "lib/base/tolerance.h"
#include "lib/correct/link_finder.h"

// Straight rapids that begin or end at a contact. There no rapid can keep the clearance.

namespace gouge {
namespace {

constexpr double kLengths[] = {1.05, 1.5, 2, 3, 4};  // lengths in which a rapid may leave a contact, in clearances

Pose moved(const Pose& from, const Vec3& along, double way_mm) { return {from.tip + way_mm * along, from.axis}; }

}  // namespace

/// Returns whether the straight rapid keeps the clearance except where it leaves a contact at its start, and where it
/// comes to one at its end. Requires that it is clean.
bool LinkFinder::keeps_beyond_contacts(const Pose& from, const Pose& to) const {
  const Vec3 way = to.tip - from.tip;
  const double length = way.norm();
  const MotionLaw& law = task_.options.law;
  const bool is_fixed_axis = (from.axis - to.axis).norm() <= Tolerance::kFileAxis;
  const bool is_along_one = way.cwiseAbs().maxCoeff() >= length - Tolerance::kSamePoint_mm;
  const bool is_straight = (law.rapid() != RapidMode::dogleg || is_along_one) && !law.bends_without_turning();
  if (!is_fixed_axis || !is_straight || !(length > Tolerance::kSamePoint_mm)) return false;
  const std::optional<double> begin_mm = way_to_leave_mm(from, to), end_mm = way_to_leave_mm(to, from);
  // Where both parts meet, the rapid is near nothing except its ends.
  if (begin_mm.value_or(0) + end_mm.value_or(0) >= length) return true;
  const Vec3 along = way / length;
  return begin_mm && end_mm &&
         is_clean(moved(from, along, *begin_mm), moved(to, along, -*end_mm), task_.rapid_clearance_mm);
}

/// Returns the length in which the way from `from` to `to` gains the clearance; 0 if it has it at once. Along the tool
/// axis it is a lift, which may follow a wall. Other ways must lead away from the contact. Returns nothing if the way
/// does not gain the clearance so.
std::optional<double> LinkFinder::way_to_leave_mm(const Pose& from, const Pose& to) const {
  const double clearance = task_.rapid_clearance_mm, length = (to.tip - from.tip).norm();
  const auto keeps = [&](const Pose& pose) { return is_clean(pose, pose, clearance); };
  if (keeps(from)) return 0;
  const Vec3 along = (to.tip - from.tip) / length;
  const bool is_lift =
      along.dot(from.axis) > 0 && side_shift_mm(to.tip - from.tip, from.axis) <= Tolerance::kFilePoint_mm;
  if (is_lift) {
    for (const double way : lifts_of_way(from, to)) {
      if (way >= length) return length;
      if (keeps(moved(from, along, way))) return way;
    }
    return std::nullopt;
  }
  for (const double clearances : kLengths) {
    const double way = clearances * clearance;
    if (way >= length) break;
    const Pose away = moved(from, along, way);
    if (keeps(away)) return is_leaving(from, away) ? std::optional(way) : std::nullopt;
  }
  return std::nullopt;
}

/// Returns whether the distance grows on the way from a contact to a position with the clearance. It must be at least
/// half of that of an even growth. The last eighth at the contact only has to be clean.
bool LinkFinder::is_leaving(const Pose& from, const Pose& away) const {
  constexpr int kStretches = 3;
  constexpr double kShareOfEven = 0.5;
  const Vec3 way = away.tip - from.tip;
  for (int k = 0; k < kStretches; ++k) {
    const double end = std::ldexp(1.0, -k), begin = 0.5 * end;
    const Pose inner{from.tip + begin * way, from.axis}, outer{from.tip + end * way, from.axis};
    if (!is_clean(inner, outer, kShareOfEven * begin * task_.rapid_clearance_mm)) return false;
  }
  return true;
}

}  // namespace gouge

#include "postproc/compare/compare_excess.h"

#include <algorithm>

#include "lib/base/number_text.h"
#include "postproc/report/report_text.h"

namespace gouge {
namespace {

/// Material of one run on all parts.
struct LeftMaterial {
  bool is_sought = false;
  double asked_mm = 0;
  double proved_mm = 0, upper_mm = 0;  ///< bounds of the largest height
  std::size_t places = 0, open = 0;    ///< all places, and those at which nothing is proved

  [[nodiscard]] std::string text(LengthUnit unit) const {
    if (!is_sought) return "not sought";
    if (places == 0) return "none above " + length_text(asked_mm, unit);
    const std::string where = " at " + count_text(places, "place");
    if (open == places) return "not certain, up to " + depth_text(upper_mm, unit) + where;
    return depth_text(proved_mm, unit) + " to " + depth_text(upper_mm, unit) + where;
  }
};

LeftMaterial material_of(const StoredResult& result) {
  LeftMaterial left;
  if (!result.record.excess) return left;
  left.is_sought = true;
  left.asked_mm = result.record.excess->asked_mm;
  for (const ExcessPlaceRecord& place : result.record.excess->places) {
    ++left.places;
    if (!place.height_mm) ++left.open;
    left.proved_mm = std::max(left.proved_mm, place.height_mm.value_or(0));
    left.upper_mm = std::max(left.upper_mm, place.height_upper_mm);
  }
  return left;
}

Change change_of(const LeftMaterial& old, const LeftMaterial& now, double same_within_mm) {
  const bool is_less_strict = !now.is_sought || (old.is_sought && now.asked_mm > old.asked_mm);
  if (now.proved_mm > 0 && old.proved_mm <= 0 && old.open == 0) return Change::fresh;
  if (now.proved_mm > old.upper_mm + same_within_mm) return Change::deeper;
  if ((is_less_strict && old.places > 0) || (now.open > 0 && old.open == 0)) return Change::not_checked;
  if (now.places == 0) return Change::gone;
  return now.upper_mm + same_within_mm < old.proved_mm ? Change::shallower : Change::same;
}

}  // namespace

std::optional<ExcessComparison> compare_excess(const StoredResult& before, const StoredResult& after,
                                               double same_within_mm) {
  const LeftMaterial old = material_of(before), now = material_of(after);
  if (old.places + now.places == 0) return std::nullopt;
  const LengthUnit unit = after.record.unit;
  return ExcessComparison{change_of(old, now, same_within_mm),
                          "material left on the part: " + now.text(unit) + "; before: " + old.text(unit)};
}

}  // namespace gouge

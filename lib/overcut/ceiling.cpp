#include "lib/overcut/ceiling.h"

#include <algorithm>

namespace gouge {
namespace {

constexpr double kAbove_mm = 1e-6;  // height above the highest surface up to which the column must be free

}  // namespace

std::optional<double> ceiling(const Surface& solid, Column column, double reach_mm, double cutoff_mm, double max_mm,
                              bool is_through_outside, std::uint32_t near) {
  column.low_mm = -reach_mm;
  column.high_mm = std::max(reach_mm, max_mm) + kAbove_mm;
  const auto height = highest_in_column(solid.tree(), column, cutoff_mm, max_mm);
  if (!height || (is_through_outside && *height < 0)) return height;
  if (solid.closest_point_from(column.through + column.high_mm * column.direction, near).is_inside) return std::nullopt;
  return height;
}

}  // namespace gouge

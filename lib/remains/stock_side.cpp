#include "lib/remains/stock_side.h"

#include <algorithm>

#include "lib/base/tolerance.h"

namespace gouge {

namespace {

/// Returns the points of a region as a piece of space that rests.
SweptPiece piece_of(const HullRegion& region, double slack_mm) {
  static_assert(HullRegion::kMaxPoints <= SweptPiece::kMaxDiscs);
  SweptPiece piece;
  piece.count = region.count;
  piece.slack_mm = slack_mm;
  for (std::size_t k = 0; k < region.count; ++k) piece.at0[k] = piece.at1[k] = {region.corners[k], Vec3::UnitZ(), 0};
  return piece;
}

}  // namespace

StockSide::Value GoneSide::at(const Vec3& point, double within_mm) const {
  const StockSolid::Distance stock = after_.stock.signed_distance(point);
  Value value{stock.mm - after_.inset_mm, stock.outward};
  // A point at distance -d from a cutter is d inside it.
  const double within = std::min(within_mm, -stock.mm);
  if (const auto place = after_.history.nearest_place(point, after_.before, within, PlacesOf::cutters))
    return {-place->distance_mm - after_.inset_mm, Vec3(-place->outward)};
  if (-within_mm > stock.mm) value.mm = -within_mm - after_.inset_mm;
  return value;
}

// The history proves with cutters that are wider by the resolution; that much slack makes them as they are.
bool GoneSide::proves(const HullRegion& region, CutMove& hint) const {
  if (after_.stock.is_apart_from(region, after_.rounding_mm)) return true;
  return after_.history.is_removed(piece_of(region, after_.resolution_mm + after_.rounding_mm), after_.before, hint);
}

bool GoneSide::proves_widened(const HullRegion& region, CutMove& hint) const {
  if (after_.stock.is_clear_of(piece_of(region, 0).start(), after_.rounding_mm - after_.resolution_mm)) return true;
  return after_.history.is_removed(piece_of(region, after_.rounding_mm), after_.before, hint);
}

StockSide::Value ThereSide::at(const Vec3& point, double within_mm) const {
  const StockSolid::Distance stock = after_.stock.signed_distance(point);
  const Value value{-stock.mm - after_.inset_mm, Vec3(-stock.outward)};
  const double within = std::min(within_mm, -stock.mm);
  if (const auto place = after_.history.nearest_place(point, after_.before, within, PlacesOf::tools))
    return {place->distance_mm - after_.inset_mm, place->outward};
  return -stock.mm > within_mm ? Value{within_mm - after_.inset_mm, value.rise} : value;
}

bool ThereSide::proves(const HullRegion& region, CutMove& hint) const {
  return after_.stock.contains(region, after_.rounding_mm) &&
         after_.history.is_untouched(region, after_.rounding_mm, after_.before, hint);
}

}  // namespace gouge

// The places of tools beside points and regions: CutHistory::nearest_place and is_untouched for a region.

#include <limits>

#include "lib/base/tolerance.h"
#include "lib/stock/cut_history.h"

namespace gouge {

namespace {

NearestPlace distance_from_box(const Vec3& point, const Vec3& low, const Vec3& high) {
  NearestPlace place{-std::numeric_limits<double>::infinity(), Vec3::UnitZ()};
  for (int k = 0; k < 3; ++k) {
    if (point[k] - high[k] > place.distance_mm) place = {point[k] - high[k], Vec3::Unit(k)};
    if (low[k] - point[k] > place.distance_mm) place = {low[k] - point[k], Vec3(-Vec3::Unit(k))};
  }
  return place;
}

}  // namespace

MovePlaces CutHistory::places_of(std::size_t move, std::uint32_t segment) const {
  if (is_straight_with_fixed_axis(move)) return {path_.start_of(move), path_.moves[move].end.tip};
  return {motion_of(move), segment};
}

std::optional<NearestPlace> CutHistory::nearest_place(const Vec3& point, std::size_t before, double within_mm,
                                                      PlacesOf places) const {
  std::optional<NearestPlace> found = own_nearest_place(point, before, within_mm, places);
  for (const CutHistory* program = earlier_; program != nullptr; program = program->earlier_) {
    const double within = found ? found->distance_mm : within_mm;
    if (const auto nearer = program->own_nearest_place(point, program->size(), within, places)) found = nearer;
  }
  return found;
}

bool CutHistory::is_untouched(const HullRegion& region, double slack_mm, std::size_t before, CutMove& hint) const {
  if (!is_left_alone(region, slack_mm, before, hint)) return false;
  for (const CutHistory* program = earlier_; program != nullptr; program = program->earlier_)
    if (!program->is_left_alone(region, slack_mm, program->size(), hint)) return false;
  return true;
}

std::optional<NearestPlace> CutHistory::own_nearest_place(const Vec3& point, std::size_t before, double within_mm,
                                                          PlacesOf places) const {
  std::optional<NearestPlace> found;
  double most = within_mm;
  if (places == PlacesOf::tools) {
    for (const Unknown& unknown : unknown_) {
      if (unknown.move >= before) break;
      const NearestPlace place = distance_from_box(point, unknown.low, unknown.high);
      if (place.distance_mm < most) found = place, most = place.distance_mm;
    }
  }
  for (std::size_t k = 0; k < of_tool_.size(); ++k) {
    if (of_tool_[k].tree == nullptr) continue;
    const bool is_whole = places == PlacesOf::tools;
    const CompiledTool& body = is_whole ? tools_[k].tool->bare : tools_[k].tool->cutting;
    if (body.elements.empty()) continue;
    const auto take_place_of = [&](const CompiledTool& of, const MotionSpan& s) {
      const MovePlaces way = places_of(s.move, s.segment);
      const auto nearest = way.nearest(of, s.from(), s.until(), point, most);
      if (!nearest) return false;
      most = nearest->distance_mm;
      found = NearestPlace{most, outward_of(of, way.at(nearest->t), point)};
      return false;
    };
    const auto take = [&](const MotionSpan& s) { return (is_whole || is_cutting(s.move)) && take_place_of(body, s); };
    for (const BodyHulls& part : of_tool_[k].bodies) {
      if (!is_whole && part.body != Body::cutter) continue;
      of_tool_[k].tree->find({point, Vec3::Zero(), 0, most}, part.around, static_cast<std::uint32_t>(before), take);
    }
    if (!is_whole) continue;
    for (const StockHead& head : heads_) {
      of_tool_[k].tree->find({point, Vec3::Zero(), 0, most}, head.cylinder(), static_cast<std::uint32_t>(before),
                             [&](const MotionSpan& s) { return take_place_of(head.around(), s); });
    }
  }
  return found;
}

bool CutHistory::is_left_alone(const HullRegion& region, double slack_mm, std::size_t before, CutMove& hint) const {
  const double slack = slack_mm + Tolerance::kRounding_mm;
  const Vec3 low = region.low() - Vec3::Constant(slack), high = region.high() + Vec3::Constant(slack);
  for (const Unknown& unknown : unknown_) {
    if (unknown.move >= before) break;
    if ((low.array() <= unknown.high.array()).all() && (high.array() >= unknown.low.array()).all()) return false;
  }
  const Vec3 middle = region.middle();
  const double ball = region.reach_mm(middle) + slack;
  for (std::size_t k = 0; k < of_tool_.size(); ++k) {
    if (of_tool_[k].tree == nullptr) continue;
    const CompiledTool& bare = tools_[k].tool->bare;
    const auto off = [&](std::size_t move) { return departure_of(move).at_mm(of_tool_[k].reach_mm); };
    for (const BodyHulls& part : of_tool_[k].bodies) {
      Vec3 away = Vec3::Zero();
      if (hint.program == this && hint.move < before && path_.moves[hint.move].tool == k &&
          is_straight_with_fixed_axis(hint.move) &&
          !places_of(hint.move, 0).is_apart(bare, part.hulls, 0, 1, region, slack + off(hint.move), away))
        return false;
      const auto may_touch = [&](const MotionSpan& s) {
        const bool does = !places_of(s.move, s.segment)
                               .is_apart(bare, part.hulls, s.from(), s.until(), region, slack + off(s.move), away);
        if (does) hint = {this, s.move};
        return does;
      };
      if (of_tool_[k].tree->find({middle, Vec3::Zero(), 0, ball}, part.around, static_cast<std::uint32_t>(before),
                                 may_touch))
        return false;
    }
    // A head counts as the solid of revolution about it: its turn does not matter then.
    for (const StockHead& head : heads_) {
      Vec3 away = Vec3::Zero();
      const auto may_touch = [&](const MotionSpan& s) {
        return !places_of(s.move, s.segment)
                    .is_apart(head.around(), head.hulls(), s.from(), s.until(), region,
                              slack + departure_of(s.move).at_mm(head.reach_mm()), away);
      };
      if (of_tool_[k].tree->find({middle, Vec3::Zero(), 0, ball}, head.cylinder(), static_cast<std::uint32_t>(before),
                                 may_touch))
        return false;
    }
  }
  return true;
}

}  // namespace gouge

#include "postproc/report/excess_text.h"

#include <cmath>

#include "lib/base/number_text.h"
#include "postproc/report/report_text.h"

namespace gouge {
namespace {

constexpr int kAreaDigits = 3;
constexpr double kSameShare = 1e-3;

std::string number_of(double area, bool is_rounded_up) {
  const double digits = area > 0 ? std::floor(std::log10(area)) + 1 : 1;
  const double step = std::pow(10, digits - kAreaDigits);
  const double rounded =
      (is_rounded_up ? std::ceil(area / step - kSameShare) : std::floor(area / step + kSameShare)) * step;
  return display_text(rounded, std::max(0, kAreaDigits - static_cast<int>(digits)));
}

std::string height_range(const ExcessPlaceFacts& place, LengthUnit unit) {
  return length_text(place.height_mm, unit) + " to " + length_text(place.height_upper_mm, unit);
}

}  // namespace

std::string area_range_text(double low_mm2, double high_mm2, LengthUnit unit) {
  const double square = mm_per(unit) * mm_per(unit);
  const std::string low = number_of(low_mm2 / square, false), high = number_of(high_mm2 / square, true);
  return (low == high ? low : low + " to " + high) + " " + unit_name(unit) + "2";
}

std::string excess_kind(const ExcessPlaceFacts& place) { return place.is_proved() ? "material left" : "material open"; }

std::string why_open_text(const ExcessPlaceFacts& place) {
  if (place.is_proved()) return {};
  if (place.unknown_move == kNone) return "a tool touched it without cutting it for certain, or the budget ended";
  return "the motion of line " + std::to_string(place.unknown_line) +
         (place.unknown_file.empty() ? "" : " of " + place.unknown_file) + " is not known";
}

std::string excess_place_text(const ReportModel& model, const ExcessPlaceFacts& place) {
  const LengthUnit unit = model.toolpath->unit;
  const std::string where = " at " + point_text(place.point, unit) + ", facet " + std::to_string(place.facet) +
                            ", on " + area_range_text(place.area_mm2, place.area_upper_mm2, unit);
  if (place.is_proved()) return height_range(place, unit) + where;
  return "up to " + length_text(place.height_upper_mm, unit) + " may be left" + where + ": " + why_open_text(place);
}

std::string excess_text(const ReportModel& model) {
  if (!model.result->excess) return {};
  const ExcessFacts& facts = *model.result->excess;
  const LengthUnit unit = model.toolpath->unit;
  const std::string asked = length_text(facts.asked_mm, unit);
  const std::size_t proved = facts.proved(), open = facts.places.size() - proved;
  double low = 0, high = 0;
  for (const ExcessPlaceFacts& place : facts.places) {
    low += place.area_mm2;
    high += place.area_upper_mm2;
  }
  std::string text = proved > 0 ? "more than " + asked + " of material is left in " + count_text(proved, "place") +
                                      ", the highest " + height_range(facts.places.front(), unit)
                     : open > 0 ? "no place is proved to have more than " + asked + " of material left"
                                : "no more than " + length_text(facts.asked_mm + facts.resolution_mm, unit) +
                                      " of material is left on the part";
  if (open > 0) text += ", and it is open in " + count_text(open, "place");
  if (proved + open > 0) text += "; area " + area_range_text(low, high, unit);
  return text + ", measured along the normals of " + area_range_text(facts.surface_mm2, facts.surface_mm2, unit) +
         "; material thinner than " + length_text(2 * facts.resolution_mm, unit) + " counts as removed";
}

std::string excess_headline(const CheckResult& result, LengthUnit unit) {
  const ExcessFacts& facts = *result.excess;
  return std::string("material left: ") + (result.counts.gouge > 0 ? "all gouges are accepted" : "no gouge") +
         ", but more than " + length_text(facts.asked_mm, unit) + " of material is left in " +
         count_text(facts.proved(), "place") + ", the highest " + height_range(facts.places.front(), unit) + " at " +
         point_text(facts.places.front().point, unit);
}

}  // namespace gouge

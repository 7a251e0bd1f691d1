#include "toolmodels/cutter.h"

#include <cmath>

#include "toolmodels/cutter_fields.h"
#include "toolmodels/cutter_shapes.h"

namespace gouge {
namespace {

template <std::size_t... I>
std::vector<Cutter> all_shapes(std::index_sequence<I...>) {
  return {Cutter(std::in_place_index<I>)...};
}

double field_or(const Cutter& cutter, std::initializer_list<std::string_view> keys, double otherwise) {
  Cutter copy = cutter;
  double found = otherwise;
  detail::visit_fields(copy, [&](const detail::CutterField& field) {
    for (const std::string_view key : keys)
      if (field.key == key) found = *field.value;
  });
  return found;
}

}  // namespace

const char* shape_name(const Cutter& cutter) {
  constexpr const char* kNames[] = {"flat",    "ball",     "bull_nose", "tapered",      "apt",      "drill",
                                    "chamfer", "lollipop", "t_slot",    "slitting_saw", "dovetail", "barrel",
                                    "oval",    "lens",     "face_mill", "radius_mill",  "profile"};
  static_assert(std::size(kNames) == std::variant_size_v<Cutter>);
  return kNames[cutter.index()];
}

const std::vector<Cutter>& every_shape() {
  static const std::vector<Cutter> kShapes = all_shapes(std::make_index_sequence<std::variant_size_v<Cutter>>());
  return kShapes;
}

double length_mm(const Cutter& cutter) {
  if (const auto* c = std::get_if<SlittingSawCutter>(&cutter)) return c->cap_height_mm + c->thickness_mm;
  if (const auto* c = std::get_if<ProfileCutter>(&cutter)) return c->points.empty() ? 0 : c->points.back().z_mm;
  const double given = field_or(cutter, {"length", "h"}, 0);
  if (given > 0) return given;
  if (const auto* c = std::get_if<ChamferCutter>(&cutter)) return detail::cone_height_mm(*c);
  if (const auto* c = std::get_if<LollipopCutter>(&cutter)) return detail::ball_height_mm(*c);
  return given;
}

NominalSize nominal_size(const Cutter& cutter) {
  if (const auto* ball = std::get_if<BallCutter>(&cutter)) return {ball->diameter_mm, ball->diameter_mm / 2};
  if (const auto* ball = std::get_if<LollipopCutter>(&cutter)) return {ball->diameter_mm, ball->diameter_mm / 2};
  NominalSize size{field_or(cutter, {"diameter", "d"}, 0), field_or(cutter, {"corner_radius", "r"}, 0)};
  if (size.diameter_mm > 0) return size;
  if (const Result<Profile> profile = make_cutter_profile(cutter))
    for (const ProfileElement& e : profile->elements)
      size.diameter_mm = std::max({size.diameter_mm, 2 * e.a.x(), 2 * e.b.x()});
  return size;
}

Result<Profile> make_cutter_profile(const Cutter& cutter) {
  return std::visit([](const auto& shape) { return detail::make_shape(shape); }, cutter);
}

}  // namespace gouge

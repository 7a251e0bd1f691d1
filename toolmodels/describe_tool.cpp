#include <algorithm>
#include <cmath>

#include "lib/base/number_text.h"
#include "toolmodels/cutter_fields.h"
#include "toolmodels/draw_profile.h"

namespace gouge {
namespace {

// Returns the abbreviation of a field in captions; nothing for a field that captions state elsewhere.
std::string_view word_of(std::string_view key) {
  static constexpr std::pair<std::string_view, std::string_view> kWords[] = {{"diameter", "D"},
                                                                             {"d", "D"},
                                                                             {"corner_radius", "R"},
                                                                             {"r", "R"},
                                                                             {"taper_angle", "taper"},
                                                                             {"alpha", "alpha"},
                                                                             {"beta", "beta"},
                                                                             {"point_angle", "point"},
                                                                             {"tip_diameter", "tip D"},
                                                                             {"neck_diameter", "neck D"},
                                                                             {"upper_radius", "upper R"},
                                                                             {"thickness", "thickness"},
                                                                             {"cap_diameter", "cap D"},
                                                                             {"profile_radius", "profile R"},
                                                                             {"largest_diameter", "to D"},
                                                                             {"recess_diameter", "recess D"}};
  for (const auto& [name, word] : kWords)
    if (name == key) return word;
  return {};
}

}  // namespace

std::string describe_cutter(const Cutter& cutter, LengthUnit unit) {
  std::string text = shape_name(cutter);
  std::ranges::replace(text, '_', '-');
  Cutter copy = cutter;
  detail::visit_fields(copy, [&](const detail::CutterField& field) {
    const std::string_view word = word_of(field.key);
    if (word.empty() || (field.otherwise && std::abs(*field.value) <= 0)) return;
    const bool is_angle = field.kind == detail::FieldKind::angle;
    const double value = is_angle ? *field.value : *field.value / mm_per(unit);
    text += " " + std::string(word) + " " + exact_text(std::round(value * 1e4) / 1e4) + (is_angle ? " deg" : "");
  });
  if (const auto* profile = std::get_if<ProfileCutter>(&cutter))
    text += " of " + std::to_string(profile->points.size()) + " points";
  return text;
}

}  // namespace gouge

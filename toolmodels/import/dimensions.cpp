#include "toolmodels/import/dimensions.h"

#include <cmath>
#include <utility>

#include "lib/base/number_text.h"

namespace gouge {

bool is_angle(Dimension dimension) {
  return dimension == Dimension::taper_angle || dimension == Dimension::bottom_angle ||
         dimension == Dimension::point_angle || dimension == Dimension::entering_angle;
}

std::string Dimensions::text(Dimension dimension) const {
  const Given& given = *(*this)[dimension];
  return given.key + " " + (is_angle(dimension) ? degrees_text(given.value) : mm_text(given.value));
}

std::optional<Dimension> catalogue_dimension(std::string_view symbol) {
  using enum Dimension;
  static constexpr std::pair<std::string_view, Dimension> kNames[] = {
      {"DC", diameter},
      {"DCX", largest_diameter},
      {"RE", corner_radius},
      {"LCF", flute_length},
      {"APMX", flute_length},
      {"OAL", overall_length},
      {"LB", body_length},
      {"LPR", body_length},
      {"SFDM", shank_diameter},
      {"DMM", shank_diameter},
      {"DCON", shank_diameter},
      {"DCONMS", shank_diameter},
      {"TA", taper_angle},
      {"SIG", point_angle},
      {"shoulder-length", shoulder_length},
      {"LN", shoulder_length},
      {"shoulder-diameter", shoulder_diameter},
      {"DN", shoulder_diameter},
      {"tip-diameter", tip_diameter},
      {"tip-length", tip_length},
      {"lower-radius", lower_radius},
      {"upper-radius", upper_radius},
      {"profile-radius", profile_radius},
      {"PRFRAD", profile_radius},
      {"axial-distance", axial_distance},
      {"CW", flute_length},
      {"KAPR", entering_angle},
  };
  for (const auto& [name, dimension] : kNames)
    if (name == symbol) return dimension;
  return std::nullopt;
}

namespace {

std::string rounded(double value) {
  if (!std::isfinite(value)) return "not a number";
  return exact_text(std::round(value * 1e4) / 1e4);
}

}  // namespace

std::string mm_text(double value_mm) { return rounded(value_mm) + " mm"; }

std::string degrees_text(double value_deg) { return rounded(value_deg) + " degrees"; }

}  // namespace gouge

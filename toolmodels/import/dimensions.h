#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "lib/base/result.h"

// The dimensions of tool catalogues, independent of their names in a file.

namespace gouge {

enum class Dimension {
  diameter,           ///< DC
  largest_diameter,   ///< DCX
  corner_radius,      ///< RE
  flute_length,       ///< LCF, APMX: tip to top of the flutes
  overall_length,     ///< OAL: tip to the end inside the holder
  body_length,        ///< LB, LPR: tip to holder
  shank_diameter,     ///< SFDM, DMM, DCONMS
  taper_angle,        ///< TA: HALF angle, between side and axis, degrees
  bottom_angle,       ///< between bottom and tip plane, degrees
  point_angle,        ///< SIG: included angle of a point, degrees
  shoulder_length,    ///< LN: tip to the end of the neck or shoulder
  shoulder_diameter,  ///< DN
  tip_diameter,
  tip_length,      ///< length of the straight part at the tip
  lower_radius,    ///< radius of the corner at the tip of a circle segment
  upper_radius,    ///< radius of the corner at the top of the flutes
  profile_radius,  ///< PRFRAD: radius of the arc of the flank or of the bottom
  axial_distance,  ///< tip to the widest point of a barrel
  cap_diameter,
  cap_height,
  entering_angle,  ///< KAPR: between edge and tip plane, degrees; 90 minus the taper angle
  count
};

/// A number of a file, in mm or degrees, with its name in the file.
struct Given {
  double value = 0;
  std::string key;
};

[[nodiscard]] bool is_angle(Dimension dimension);

class Dimensions {
 public:
  void set(Dimension dimension, double value, std::string key) { slot(dimension) = Given{value, std::move(key)}; }
  [[nodiscard]] const std::optional<Given>& operator[](Dimension dimension) const {
    return given_[static_cast<std::size_t>(dimension)];
  }
  /// Returns the value, or `otherwise` if the file does not give the dimension.
  [[nodiscard]] double value_or(Dimension dimension, double otherwise) const {
    const std::optional<Given>& given = (*this)[dimension];
    return given ? given->value : otherwise;
  }
  /// Returns "LCF 20 mm". Requires the dimension to be given.
  [[nodiscard]] std::string text(Dimension dimension) const;

 private:
  std::optional<Given>& slot(Dimension dimension) { return given_[static_cast<std::size_t>(dimension)]; }

  std::array<std::optional<Given>, static_cast<std::size_t>(Dimension::count)> given_;
};

/// Returns the dimension with this symbol of ISO 13399 or of Fusion; most symbols of both are the same.
[[nodiscard]] std::optional<Dimension> catalogue_dimension(std::string_view symbol);

/// Returns "12.5 mm", rounded to digits that are useful for a reader.
[[nodiscard]] std::string mm_text(double value_mm);
[[nodiscard]] std::string degrees_text(double value_deg);

}  // namespace gouge

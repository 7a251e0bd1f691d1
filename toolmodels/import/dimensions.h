#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "lib/base/result.h"

// The dimensions tool catalogues name, under whatever name a file gives them.

namespace gouge {

enum class Dimension {
  diameter,           ///< DC
  largest_diameter,   ///< DCX
  corner_radius,      ///< RE
  flute_length,       ///< LCF, APMX: tip to top of the flutes
  overall_length,     ///< OAL: tip to the end inside the holder
  body_length,        ///< LB, LPR: tip to holder
  shank_diameter,     ///< SFDM, DMM, DCONMS
  taper_angle,        ///< TA: side against the axis, degrees; the HALF angle
  bottom_angle,       ///< bottom against the tip plane, degrees
  point_angle,        ///< SIG: included angle of a point, degrees
  shoulder_length,    ///< LN: tip to the end of the neck or shoulder
  shoulder_diameter,  ///< DN
  tip_diameter,
  tip_length,      ///< straight part at the tip
  lower_radius,    ///< corner at the tip of a circle segment
  upper_radius,    ///< at the top of the flutes
  profile_radius,  ///< PRFRAD: of the flank or bottom arc
  axial_distance,  ///< tip to the widest point of a barrel
  cap_diameter,
  cap_height,
  entering_angle,  ///< KAPR: edge against the tip plane, degrees; 90 less the taper angle
  count
};

/// A number as the file gives it: mm or degrees, with the file's own name for it.
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
  /// Returns the value, or `otherwise` when the file states nothing.
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

/// Symbols of ISO 13399 and those of Fusion, most of which are the same.
[[nodiscard]] std::optional<Dimension> catalogue_dimension(std::string_view symbol);

/// Returns "12.5 mm", rounded to what a reader can use.
[[nodiscard]] std::string mm_text(double value_mm);
[[nodiscard]] std::string degrees_text(double value_deg);

}  // namespace gouge

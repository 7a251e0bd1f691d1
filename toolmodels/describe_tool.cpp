#include <cmath>

#include "lib/base/number_text.h"
#include "toolmodels/draw_profile.h"

namespace gouge {
namespace {

struct Describe {
  LengthUnit unit;

  [[nodiscard]] std::string length(double value_mm) const {
    return exact_text(std::round(value_mm / mm_per(unit) * 1e4) / 1e4);
  }
  [[nodiscard]] static std::string angle(double degrees) {
    return exact_text(std::round(degrees * 1e4) / 1e4) + " deg";
  }
  std::string operator()(const FlatCutter& t) const { return "flat D " + length(t.diameter_mm); }
  std::string operator()(const BallCutter& t) const { return "ball D " + length(t.diameter_mm); }
  std::string operator()(const BullNoseCutter& t) const {
    return "bull_nose D " + length(t.diameter_mm) + " R " + length(t.corner_radius_mm);
  }
  std::string operator()(const TaperedCutter& t) const {
    return "tapered D " + length(t.diameter_mm) + " R " + length(t.corner_radius_mm) + " taper " +
           angle(t.taper_angle_deg);
  }
  std::string operator()(const AptCutter& t) const {
    return "apt D " + length(t.d_mm) + " R " + length(t.r_mm) + " alpha " + angle(t.alpha_deg) + " beta " +
           angle(t.beta_deg);
  }
};

}  // namespace

std::string describe_cutter(const Cutter& cutter, LengthUnit unit) {
  return std::visit(Describe{unit}, cutter);
}

}  // namespace gouge

#include "postproc/report/cure_text.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lib/base/number_text.h"
#include "lib/base/tolerance.h"
#include "postproc/report/report_text.h"

namespace gouge {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

std::string tilt_words(const TiltCure& tilt) {
  // Rounded up: it is what the machine must be able to do.
  constexpr double kDecimals = 100;
  if (tilt.tilt_rad) {
    const double degrees = std::ceil(*tilt.tilt_rad / kDegree * kDecimals - Tolerance::kRounding) / kDecimals;
    return "a tilt of up to " + people_text(degrees, 2) + " deg";
  }
  return "no tilt (" + tilt.reason + ")";
}

std::string lift_words(const ReportModel& model, const LiftCure& lift) {
  const LengthUnit unit = model.toolpath->unit;
  if (lift.lift_mm) {
    return "a lift of " + short_length_text(*lift.lift_mm, unit) + " along the tool axis" +
           (lift.is_least() ? ""
                            : ", proved; whether less is enough, from " +
                                  short_length_text(lift.not_free_below_mm, unit) + " on, is not certified");
  }
  const std::string where = "line " + std::to_string(std::size_t{model.toolpath->moves[lift.move].line});
  return "no lift up to " + length_text(model.cure_options->most_lift_mm, unit) + " along the tool axis (the " +
         body_name(lift.body) + ", " + where + ")";
}

}  // namespace

const FindingCures* cures_of(const ReportModel& model, std::size_t event) {
  const auto found = std::ranges::lower_bound(model.cures, event, {}, &FindingCures::event);
  return found != model.cures.end() && found->event == event ? &*found : nullptr;
}

std::string cure_text(const ReportModel& model, const FindingCures& cures) {
  return tilt_words(cures.tilt) + "; " + lift_words(model, cures.lift);
}

}  // namespace gouge

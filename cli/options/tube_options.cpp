#include "cli/options/tube_options.h"

#include "cli/terminal/length_text.h"
#include "lib/base/number_text.h"
#include "lib/base/units.h"

namespace gouge {

Result<MotionTube> understand_tube(const std::string& tip, const std::string& axis, bool has_heads) {
  MotionTube tube;
  if (!tip.empty()) {
    const Result<double> length_mm = understand_length("--tip-tolerance", tip, Minimum::zero);
    if (!length_mm) return length_mm.error();
    tube.tip_mm = *length_mm;
  }
  if (!axis.empty()) {
    const std::optional<double> degrees = parse_number(axis);
    if (!degrees || !(*degrees >= 0) || *degrees > kMaxAxisTolerance_deg)
      return usage_error("--axis-tolerance", axis, "degrees from 0 to " + display_text(kMaxAxisTolerance_deg, 0));
    tube.axis_rad = *degrees * kDegree_rad;
  }
  if (has_heads && !tube.is_empty())
    return make_error("usage",
                      "--tip-tolerance and --axis-tolerance cover the tool, not the bodies of --head; leave out one or "
                      "the other");
  return tube;
}

}  // namespace gouge

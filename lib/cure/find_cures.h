#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lib/cure/find_lift.h"
#include "lib/tilt/tilt_options.h"

// Finds cures for collisions of non-cutting bodies, for each finding: the smallest tilt that was found, and the minimum
// lift.

namespace gouge {

struct CureOptions {
  double lift_step_mm = 0.01;  ///< lifts are multiples of this
  double max_lift_mm = 100;    ///< maximum lift that is tried
  TiltOptions tilt;
  bool has_axes = true;  ///< the file states tool axes; if not, a correction tilts it only on request
};

/// The tilt that frees a finding.
struct TiltCure {
  std::optional<double> tilt_rad;  ///< the largest tilt along its run; none: no tilt was found
  std::string reason;              ///< reason if no tilt was found
};

struct FindingCures {
  std::size_t event = 0;  ///< index into CheckResult::events
  TiltCure tilt;
  LiftCure lift;
};

/// Finds cures of every gouge and every buried finding of shank, holder and heads, in the order of the events. Findings in
/// remaining stock have none.
///
/// Requires `result` from check() with the same path and setup.
/// Ensures  (1) The lift is that of find_lift for all moves of the finding. (2) The tilt is that of the runs that
///          plan_tilts returns for the whole path, in the same way as `correct`. It turns about the contact, and begins
///          and ends gradually over the blend. It is given only if check() of the tilted path finds certain moves clean
///          or near. These are every move of the finding, and every other move that the run changed. (3) The result is
///          the same at any number of threads.
/// Cost     That of planning all tilts, of a check of the path, and of find_lift for each finding.
[[nodiscard]] std::vector<FindingCures> find_cures(const Toolpath& path, const CheckResult& result,
                                                   const CheckSetup& setup, const CureOptions& options,
                                                   const ProgressCall& progress = {});

}  // namespace gouge

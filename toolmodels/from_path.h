#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lib/base/diagnostic.h"
#include "lib/base/result.h"
#include "toolmodels/assembly.h"

namespace gouge {

/// What a toolpath says of its cutter: the numbers of CUTTER/d,r,e,f,alpha,beta,h, mm and degrees. `given` is
/// how many of them there were: 1 is a flat cutter, 2 one with corner radius, 7 the whole.
struct PathCutter {
  double d_mm = 0, r_mm = 0, e_mm = 0, f_mm = 0;
  double alpha_deg = 0, beta_deg = 0;
  double h_mm = 0;  ///< 0: not given
  int given = 0;
  double flute_length_mm = 0;  ///< 0: not given; above it the tool is shank
};

struct ToolFromPath {
  ToolAssembly tool;
  Diagnostics notes;  ///< what had to be assumed
};

/// A tool assembly from a toolpath's own words. CL data knows no holder: `holder` (may be empty) is put on
/// top. A height that is missing is the flute length; without one, or when it ends within the tip, it is
/// replaced by max(5 d, 50 mm) and told: APT's default of 5 would leave most of the tool out of the check.
///
/// Errors   those of make_cutter_profile, naming the tool.
[[nodiscard]] Result<ToolFromPath> make_tool_from_path(std::optional<int> number, const std::string& name,
                                                       const PathCutter& cutter,
                                                       const std::vector<ToolSegment>& holder);

}  // namespace gouge

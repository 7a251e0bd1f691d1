#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lib/base/units.h"
#include "lib/check/check_result.h"
#include "lib/mesh/mesh_findings.h"
#include "lib/path/assumption.h"

namespace gouge {

struct CheckSetup;

/// Facts about the inputs that the caller of a check knows and vouches for.
struct SetupBasis {
  Assumptions inputs = {};                   ///< facts about tools, holders and STL files; made where these are read
  std::optional<LengthUnit> mesh_unit = {};  ///< unit that the user states; none: the unit of the toolpath was used
  std::string place = {};                    ///< position of the part that the user states (--place); empty: not stated
  std::vector<Vouched> vouched = {};         ///< facts that the user vouches for (--assume)
  bool is_strict = false;                    ///< defaults are not allowed
  std::string law_evidence = {};             ///< source that states the law of motion; empty: no source
};

/// Returns the assumption that an STL file bounds a solid, with its state. `name` is the file as the user named it.
[[nodiscard]] Assumption assume_solid(const std::string& name, const MeshFindings& findings);

/// Completes a result with the facts on which its verdict rests, the closest approach, and the fit of path and part.
///
/// Requires verdicts for every move. Ensures the same result at any number of threads.
/// Cost     That of measure_closest_approach and find_path_fit: a search at some 450 positions, more if much gouges.
void assess(const Toolpath& path, const CheckSetup& setup, CheckResult& result);

}  // namespace gouge

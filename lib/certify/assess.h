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
  Assumptions inputs = {};                   ///< of tools, holders and STL files: made where they are read
  std::optional<LengthUnit> mesh_unit = {};  ///< as the user states it; none: the toolpath's unit was taken
  std::string place = {};                    ///< as the user states it (--place); empty: not stated
  std::vector<Vouched> vouched = {};         ///< --assume
  bool is_strict = false;                    ///< defaults are not allowed
  std::string law_evidence = {};             ///< who states the law of motion; empty: nothing does
};

/// Returns whether an STL file bounds a solid, as an assumption. `name` is the file as the user named it.
[[nodiscard]] Assumption assume_solid(const std::string& name, const MeshFindings& findings);

/// Completes a result: the facts on which its verdict rests, the closest approach and the fit of path and part.
///
/// Requires verdicts on every move. Ensures  the same result at any number of threads.
/// Cost     That of measure_closest_approach and find_path_fit: a search at some 450 positions, more where much gouges.
void assess(const Toolpath& path, const CheckSetup& setup, CheckResult& result);

}  // namespace gouge

#pragma once

#include <map>
#include <string>
#include <vector>

#include "lib/base/result.h"
#include "lib/check/scene.h"

// Limits of single meshes, typed behind the name of the file: --fixture vise.stl,clearance=1,tolerance=0.002.

namespace gouge {

/// Text typed behind the names of some files: "vise.stl" -> "clearance=1,tolerance=0.002".
using LimitTexts = std::map<std::string, std::string>;

/// Splits each value into the name of a file and its limits. A comma of the name itself stays in it.
void split_limits(const std::vector<std::string>& typed, std::vector<std::string>& files, LimitTexts& limits);

/// Returns the limits of files that were given with `option`, against obstacles of that kind.
///
/// `tolerance_mm`: of the check, which a file may lower.
/// Errors (code usage): names the option, the typed text and the expected one.
[[nodiscard]] Result<std::vector<MeshLimit>> understand_limits(const std::string& option, Against against,
                                                               const std::vector<std::string>& files,
                                                               const LimitTexts& limits, double tolerance_mm);

}  // namespace gouge

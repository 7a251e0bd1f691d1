#pragma once

#include <string>

#include "lib/base/result.h"
#include "tests/bench/workload.h"

// One case of the benchmark as the files a user has, so that the whole command can be measured.

namespace gouge::bench {

/// part.stl, tools.json and path.apt of the workload's moves. `choice`: "all" of them; "clean": positions that gouge
/// lifted along the tool's axis; "few": only the first eight stretches of them left where they are.
[[nodiscard]] Outcome write_scene_files(const std::string& folder, const WorkloadKey& key, const std::string& choice);

/// A head: a closed cylinder of radius 16 with edges rounded by 6, `bottom_mm` above the tip, 60 high, of `around` flat
/// sides and `steps` steps of each rounding: 4 * around * (steps + 1) facets.
[[nodiscard]] IndexedMesh make_head(double bottom_mm, int around, int steps);
/// The same as binary STL.
[[nodiscard]] Outcome write_head_file(const std::string& file, double bottom_mm, int around, int steps);

}  // namespace gouge::bench

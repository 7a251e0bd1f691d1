#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/job/job.h"
#include "lib/base/result.h"
#include "lib/path/path_change.h"
#include "postproc/report/report_model.h"

namespace gouge {

/// Code of the warning that a fixture penetrates a part.
inline constexpr const char* kFixtureOverlap = "fixture-overlap";
/// Code of the warning that it could not be certified whether a fixture penetrates a part.
inline constexpr const char* kFixtureUndecided = "fixture-not-certified";

/// Returns a warning about a tolerance above the radius of a cutter. Also returns one for each fixture that penetrates a
/// part deeper than the tolerance, except those of --allow-overlap. `scene` is that of the job.
[[nodiscard]] Diagnostics setup_notes(const Job& job, const JobArguments& arguments, const PreparedScene& scene);

/// Runs find_stickouts for the tools of a job; `result` is that of its check. `is_extended_up` as in JobArguments.
/// Errors   Those of make_non_cutting_variants for a longer tool.
[[nodiscard]] Result<std::vector<StickoutFacts>> find_stickouts_of(const Job& job, const PreparedScene& scene,
                                                                   const CheckResult& result, bool is_extended_up,
                                                                   const StickoutOptions& options,
                                                                   const ProgressCall& progress);

/// The speed of --max-rotary-speed in degrees a minute; none: not given.
using RotaryLimit = std::optional<double>;

/// Parses a limit of rotary speed; an empty text means no limit. An error (code usage) names the option, the typed text
/// and the expected one.
[[nodiscard]] Result<RotaryLimit> understand_rotary_limit(const std::string& typed);

/// Measures the axes of `before`, and of `after`, which results from `before` by `changes`.
[[nodiscard]] AxisFacts measure_axes(const Toolpath& before, const std::vector<PathChange>& changes,
                                     const Toolpath& after, const RotaryLimit& limit);

}  // namespace gouge

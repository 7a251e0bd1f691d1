#pragma once

#include "cli/job/job.h"

namespace gouge {

/// Code of the warning that a fixture penetrates a part.
inline constexpr const char* kFixtureOverlap = "fixture-overlap";
/// Code of the warning that it could not be certified whether one does.
inline constexpr const char* kFixtureUndecided = "fixture-not-certified";

/// Adds to the notes of a job what there is to say about its fixtures against its parts, before its path is looked at: a
/// warning for each that reaches deeper into a part than the tolerance, but for those of --allow-overlap. `scene`: that
/// of the job.
void note_setup(Job& job, const JobArguments& arguments, const PreparedScene& scene);

}  // namespace gouge

#pragma once

#include <string>

// The JSON Schemas (draft 2020-12) of the files that a user writes, generated from the tables of options.

namespace gouge {

/// Returns the schema of a project file: docs/formats/project.schema.json.
[[nodiscard]] std::string project_schema();

/// Returns the schema of a job list of `batch`: docs/formats/jobs.schema.json.
[[nodiscard]] std::string jobs_schema();

}  // namespace gouge

#pragma once

#include <string>

namespace gouge {

/// Returns the JSON Schema (draft 2020-12) of a result file, generated from result_fields.h:
/// docs/formats/report.schema.json.
[[nodiscard]] std::string result_schema();

}  // namespace gouge

#pragma once

#include <string>
#include <string_view>

#include "lib/base/result.h"
#include "lib/json/json_field.h"
#include "postproc/record/result_record.h"

namespace gouge {

/// A result file and its text, which gives errors in the record their place.
struct ReadRecord {
  JsonFile json;
  ResultRecord record;
};

/// Reads the bytes of `file`: every field that write_record writes, each with its kind and within its limits. Other
/// keys are ignored. The digest is not compared (result_digest.h).
/// Errors, with the line: result-syntax, result-duplicate-key, json-too-deep, json-too-long. Also result-format (it is
/// not a result of this program, or has another version of the format), and result-field (a value is missing or not as
/// expected).
[[nodiscard]] Result<ReadRecord> read_record(const std::string& file, std::string_view bytes);

}  // namespace gouge

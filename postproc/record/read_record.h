#pragma once

#include <string>
#include <string_view>

#include "lib/base/result.h"
#include "lib/json/json_field.h"
#include "postproc/record/result_record.h"

namespace gouge {

/// A result file and its text, which places errors found in the record.
struct ReadRecord {
  JsonFile json;
  ResultRecord record;
};

/// Reads the bytes of `file`: every field that write_record writes, each of its kind and within its limits. Keys beyond
/// these are passed over. The digest is not compared (result_digest.h).
/// Errors, with the line: result-syntax, result-duplicate-key, json-too-deep, json-too-long; result-format (no result of
/// this program, or of another version of the format), result-field (a value that is missing or not as expected).
[[nodiscard]] Result<ReadRecord> read_record(const std::string& file, std::string_view bytes);

}  // namespace gouge

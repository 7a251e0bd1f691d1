#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "lib/base/result.h"
#include "lib/json/json_lines.h"

// Reads all JSON of the program. Input that needs memory or time out of proportion to the file is rejected
// before anything of it is stored.

namespace gouge {

inline constexpr std::size_t kDeepestJson = 64;         ///< objects and lists within each other
inline constexpr std::size_t kLongestText = 1'000'000;  ///< bytes of one text or key
inline constexpr std::size_t kLongestNumber = 1'000;    ///< characters of one number

struct JsonFile {
  nlohmann::json root;
  JsonLines lines;
};

/// The expected content of a file ("a tool library"), and the codes of its errors.
struct JsonKind {
  std::string syntax_code;         ///< not JSON, or a number beyond double precision's
  std::string duplicate_key_code;  ///< an object has one key twice
  std::string what;
};

/// Reads `bytes`, a byte order mark before them or not. `file` is for messages alone. Time and memory grow
/// with the size of the text. Errors, with the line   json-too-deep, json-too-long, and those of `kind`.
[[nodiscard]] Result<JsonFile> parse_json(const std::string& file, std::string_view bytes, const JsonKind& kind);

}  // namespace gouge

#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace gouge::detail {

/// Where each value of a JSON text begins, by its JSON pointer ("/tools/0/name"), lines counted from 1.
struct JsonLines {
  std::map<std::string, std::size_t> lines;
  std::optional<std::string> duplicate;  ///< pointer of the first key that an object has twice

  /// Line of the pointer, or of the nearest thing around it.
  [[nodiscard]] std::size_t at(std::string pointer) const;
};

/// Requires a text that a JSON parser accepted; on any other the answer is incomplete but safe.
[[nodiscard]] JsonLines find_json_lines(std::string_view text);

[[nodiscard]] std::size_t line_of_byte(std::string_view text, std::size_t byte);

}  // namespace gouge::detail

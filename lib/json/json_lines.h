#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gouge {

/// Lines on which the values of a JSON text begin, by JSON pointer ("/tools/0/name"). Lines are counted from 1. They
/// are stored as a tree: with the whole pointer of every value, a small text with long keys would take gigabytes.
class JsonLines {
 public:
  struct Duplicate {
    std::string pointer;
    std::size_t line = 0;  ///< line of the second occurrence
  };

  /// Returns the line of the value at the pointer, or of the innermost value around it that exists.
  [[nodiscard]] std::size_t at(std::string_view pointer) const;

  std::optional<Duplicate> duplicate;  ///< the first key that occurs twice in an object

  /// Adds the value with that key, or with that index, to the value `parent`. The result is false if that value already
  /// exists.
  [[nodiscard]] std::pair<std::size_t, bool> add(std::size_t parent, const std::string& key, std::size_t line);
  /// Sets the line of the root, the value of the whole text. Its number is 0.
  std::size_t set_root(std::size_t line);

 private:
  std::vector<std::size_t> lines_{1};                                  // line of each value; the first value is the
                                                                       // whole text
  std::map<std::pair<std::size_t, std::string>, std::size_t> values_;  // values by parent and key
};

/// Returns the lines of all values. Requires a text that a JSON parser accepted; for other text the result is
/// incomplete but safe.
[[nodiscard]] JsonLines find_json_lines(std::string_view text);

[[nodiscard]] std::size_t line_of_byte(std::string_view text, std::size_t byte);

}  // namespace gouge

#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gouge {

/// Lines on which the values of a JSON text begin, by JSON pointer ("/tools/0/name"), lines counted from 1.
/// Kept as a tree: with the whole pointer of every value a small text of long keys would take gigabytes.
class JsonLines {
 public:
  struct Duplicate {
    std::string pointer;
    std::size_t line = 0;  ///< of the second
  };

  /// Returns the line of the pointer, or of the nearest thing around it.
  [[nodiscard]] std::size_t at(std::string_view pointer) const;

  std::optional<Duplicate> duplicate;  ///< the first key that an object has twice

  /// Adds the value of that key, or of that index, to the value `parent`; false when there is one already.
  [[nodiscard]] std::pair<std::size_t, bool> add(std::size_t parent, const std::string& key, std::size_t line);
  /// The line of the whole text's value, which is number 0.
  std::size_t set_root(std::size_t line);

 private:
  std::vector<std::size_t> lines_{1};                                  // of each value; the first one is the whole text
  std::map<std::pair<std::size_t, std::string>, std::size_t> values_;  // by parent and key
};

/// Requires a text that a JSON parser accepted; on any other the result is incomplete but safe.
[[nodiscard]] JsonLines find_json_lines(std::string_view text);

[[nodiscard]] std::size_t line_of_byte(std::string_view text, std::size_t byte);

}  // namespace gouge

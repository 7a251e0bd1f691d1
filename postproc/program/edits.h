#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace gouge {

/// New text for the bytes [first_byte, last_byte) of a toolpath file. If both are equal, the text is inserted there.
struct Edit {
  std::size_t first_byte = 0, last_byte = 0;
  std::string text;
};

/// Edits in the order of the file, without overlaps.
using Edits = std::vector<Edit>;

/// Returns the file with its edits made. All other bytes stay.
///
/// Requires Edits in order, within `source`.
/// Cost     One copy of the file.
[[nodiscard]] std::string apply_edits(std::string_view source, const Edits& edits);

}  // namespace gouge

#pragma once

#include <cstddef>
#include <string>

namespace gouge {

/// A file that is not written yet: its name without a folder, a title, and its bytes.
struct NamedFile {
  std::string name;
  std::string bytes;
  std::string title;                                ///< one short sentence about its content; may be empty
  std::size_t move = static_cast<std::size_t>(-1);  ///< for the picture of a finding: its worst move
};

}  // namespace gouge

#pragma once

#include <cstddef>
#include <string>

namespace gouge {

/// A file still to be written: its name without a folder, a title for people, and its bytes.
struct NamedFile {
  std::string name;
  std::string bytes;
  std::string title;                                ///< what it shows, one short sentence; may be empty
  std::size_t move = static_cast<std::size_t>(-1);  ///< for the picture of a finding its worst move
};

}  // namespace gouge

#pragma once

#include <string>

namespace gouge {

/// A file still to be written: its name without a folder, a title for people, and its bytes.
struct NamedFile {
  std::string name;
  std::string bytes;
  std::string title;  ///< what it shows, one short sentence; may be empty
};

}  // namespace gouge

#pragma once

#include <cstdint>
#include <string>

#include "lib/base/result.h"

namespace gouge {

struct BesideFile {
  std::string path;  ///< where it was found; the first place that was tried where it was not
  std::string bytes;
};

/// Reads the file that a tool library names `name`: in the library's folder, else in the folder Bit beside that, where
/// FreeCAD keeps them. Where none has exactly this name, upper and lower case count as equal.
///
/// Errors   file-not-found with both places; import-beside where several files differ in case alone; those of
///          read_file.
[[nodiscard]] Result<BesideFile> read_beside(const std::string& library_file, const std::string& name,
                                             std::uint64_t most_bytes);

}  // namespace gouge

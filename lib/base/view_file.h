#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "lib/base/result.h"

namespace gouge {

/// The bytes of a file, there as long as `keep` is.
struct FileView {
  std::string_view bytes;
  std::shared_ptr<const void> keep;
};

/// As read_file, but a regular file is mapped into memory instead of copied. Whoever shortens the file while
/// it is looked at ends the program, as with every mapped file.
/// Errors: those of read_file.
[[nodiscard]] Result<FileView> view_file(const std::string& path);

}  // namespace gouge

#pragma once

#include <string>
#include <string_view>

#include "lib/base/result.h"

// Whole files in, whole files out. An output file appears complete or not at all.

namespace gouge {

/// The bytes of `path`. Errors: file-not-found, file-is-folder, file-unreadable.
[[nodiscard]] Result<std::string> read_file(const std::string& path);

/// Writes beside `path` and renames, so that readers see the old file or the whole new one. Devices and
/// pipes (/dev/null, a FIFO) are written directly. Errors: file-unwritable (with the system's reason).
[[nodiscard]] Outcome write_file(const std::string& path, std::string_view bytes);

/// Creates `path` and its parents. Errors: folder-unwritable.
[[nodiscard]] Outcome make_folder(const std::string& path);

}  // namespace gouge

#pragma once

#include <string>

#include "lib/path/path_info.h"

// What `path info` shows, as text for people and as JSON. Lengths in the file's unit.

namespace gouge {

[[nodiscard]] std::string path_info_text(const Toolpath& path, const PathInfo& info, const std::string& dialect_title);
[[nodiscard]] std::string path_info_json(const Toolpath& path, const PathInfo& info);

}  // namespace gouge

#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace gouge {

/// Names the format of `bytes` where they are certainly not CL data: meshes, CAD files, NC programs, archives,
/// pictures, columns of numbers. The name is the rest of a sentence that begins with the file's name ("is G-code,
/// ..."). Nothing for what may be CL data. Examines the first lines only.
[[nodiscard]] std::optional<std::string> describe_foreign(std::string_view bytes);

}  // namespace gouge

#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace gouge {

/// Returns the format of a file if its bytes, or its name, are certainly not of CL data: meshes, CAD files, NC programs, archives, pictures,
/// columns of numbers. The text is the rest of a sentence that begins with the file's name ("is G-code, ..."). Returns
/// nothing if the bytes may be CL data. Examines only the first lines.
[[nodiscard]] std::optional<std::string> describe_foreign(std::string_view name, std::string_view bytes);

}  // namespace gouge

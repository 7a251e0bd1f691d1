#pragma once

#include <string>

namespace gouge {

/// Markup, style and script of the 3D view, and beside them `scene`, the text of a Payload. It stands behind what the
/// page has to show where the view cannot.
[[nodiscard]] std::string viewer_page(const std::string& scene);

}  // namespace gouge

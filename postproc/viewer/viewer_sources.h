#pragma once

#include <string_view>

// The files beside this one that go into a page, put here by the build (postproc/embed_text.cmake).

namespace gouge {

extern const std::string_view kViewerScript;  ///< the .js files
extern const std::string_view kViewerStyle;   ///< viewer.css
extern const std::string_view kViewerMarkup;  ///< viewer.html

}  // namespace gouge

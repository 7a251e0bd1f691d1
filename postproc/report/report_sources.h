#pragma once

#include <string_view>

// Files beside this one that go into a page, put here by the build (postproc/embed_text.cmake).

namespace gouge {

extern const std::string_view kFindingsScript;  ///< findings.js

}  // namespace gouge

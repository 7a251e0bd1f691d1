#pragma once

#include <string_view>

// Files in this folder that become part of a page. The build embeds them (postproc/embed_text.cmake).

namespace gouge {

extern const std::string_view kHtmlStyle;       ///< report.css: the style of all pages, for screens and paper
extern const std::string_view kFindingsScript;  ///< findings.js, sha256.js and review.js

}  // namespace gouge

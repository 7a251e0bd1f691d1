#pragma once

#include <string_view>

// Files in this folder that become part of the page of a batch. The build embeds them (postproc/embed_text.cmake).

namespace gouge {

extern const std::string_view kBatchStyle;   ///< batch.css, in addition to kHtmlStyle
extern const std::string_view kBatchScript;  ///< batch.js

}  // namespace gouge

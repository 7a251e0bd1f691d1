#pragma once

#include <cstdint>
#include <string>

#include "lib/base/result.h"

namespace gouge {

/// Returns a PNG file (8 bits a channel, no alpha, no metadata) of `height` rows of `width` pixels. Each pixel is three
/// bytes (blue, green, red), without gaps between rows. The same pixels give the same bytes. Requires both sides above
/// 0. Errors: "picture-not-encoded", "out-of-memory".
[[nodiscard]] Result<std::string> encode_png(const std::uint8_t* rgb, int width, int height);

}  // namespace gouge

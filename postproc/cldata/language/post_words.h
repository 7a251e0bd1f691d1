#pragma once

#include <cstdint>
#include <string_view>

// The words of post-processor records in binary NCCS files, by their codes. A major word is the subclass of its record,
// and a minor word is one of its data words. A minor word has its code in the lowest 16 bits, 0 in the highest 16, and
// no other bits set. As a number, such bits are only 0 or next to 0. The codes and their evidence:
// docs/formats/nccs.md.

namespace gouge {

/// Returns the major word; nothing if the code is unknown.
[[nodiscard]] std::string_view major_of_code(std::uint16_t subclass);

/// Returns the minor word; nothing if the code is unknown.
[[nodiscard]] std::string_view minor_of_code(std::uint16_t code);

}  // namespace gouge

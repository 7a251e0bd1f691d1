#pragma once

#include <cstdint>
#include <string_view>

// The words of post-processor records in binary NCCS files, by their codes. A major word is the subclass of its record.
// A minor word is one of the record's data words. It has its code in the lowest 16 bits and 0 in the highest. No number
// has that but 0 and those next to it; the bits between are not set. The codes and their evidence:
// docs/formats/nccs.md.

namespace gouge {

/// Returns the major word, or nothing where the code is not known.
[[nodiscard]] std::string_view major_of_code(std::uint16_t subclass);

/// Returns the minor word, or nothing where the code is not known.
[[nodiscard]] std::string_view minor_of_code(std::uint16_t code);

}  // namespace gouge

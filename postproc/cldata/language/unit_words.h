#pragma once

#include <optional>
#include <string_view>

#include "lib/base/units.h"

// The words that name a unit of length, alone or within a feed.

namespace gouge {

/// MM, MMS, MILLIMETERS, INCH, INCHES, IN; nothing for other words.
[[nodiscard]] std::optional<LengthUnit> unit_of_word(std::string_view word);

/// The length unit of a feed word (MMPM, MMPR, IPM, IPR, FPM, FPR); nothing for other words.
[[nodiscard]] std::optional<LengthUnit> unit_of_feed_word(std::string_view word);

}  // namespace gouge

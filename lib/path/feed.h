#pragma once

#include <cstdint>

namespace gouge {

/// Unit of the speed of a motion, if its file states it.
enum class FeedUnit : std::uint8_t {
  not_stated,      ///< a feed motion for which the file states no feed
  rapid,           ///< the machine's own rapid speed
  per_minute,      ///< mm per minute
  per_revolution,  ///< mm per revolution of the spindle
  not_understood   ///< stated in words that the reader does not know: inverse time, two units at once
};

/// A feed and its unit. `mm` is above 0 for per_minute and per_revolution, and 0 for the others.
struct Feed {
  double mm = 0;
  FeedUnit unit = FeedUnit::not_stated;

  [[nodiscard]] bool is_number() const { return unit == FeedUnit::per_minute || unit == FeedUnit::per_revolution; }
};

}  // namespace gouge

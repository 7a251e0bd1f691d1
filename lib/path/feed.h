#pragma once

#include <cstdint>

namespace gouge {

/// Speed of a motion, as far as its file states it.
enum class FeedUnit : std::uint8_t {
  not_stated,      ///< a feed motion whose file states no feed
  rapid,           ///< the machine's own speed
  per_minute,      ///< mm per minute
  per_revolution,  ///< mm per revolution of the spindle
  not_understood   ///< stated in words that are not read: inverse time, two units at once
};

/// A feed and its unit; `mm` is above 0 for per_minute and per_revolution and 0 for the others.
struct Feed {
  double mm = 0;
  FeedUnit unit = FeedUnit::not_stated;

  [[nodiscard]] bool is_number() const { return unit == FeedUnit::per_minute || unit == FeedUnit::per_revolution; }
};

}  // namespace gouge

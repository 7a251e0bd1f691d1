#pragma once

#include <optional>
#include <string_view>

#include "lib/base/units.h"
#include "postproc/cldata/dialect.h"

// The unit of a file's numbers, and what tells it.

namespace gouge {

/// The unit a file's positions start in, and why.
struct UnitGuess {
  LengthUnit unit = LengthUnit::mm;
  enum class Source {
    stated,     ///< by UNITS or UNIT before the first position
    option,     ///< by the user
    feed_word,  ///< suggested by a word of FEDRAT or CYCLE (MMPM, IPM)
    dialect,    ///< the dialect's writer gives no unit and means mm
    assumed     ///< nothing tells
  } source = Source::assumed;
};

/// UNITS or UNIT where the file states it before its first position, else what the feed words of FEDRAT and
/// CYCLE suggest, else what the dialect means, else mm.
[[nodiscard]] UnitGuess find_unit(std::string_view bytes, const Dialect& dialect);

/// MM, MMS, MILLIMETERS, INCH, INCHES, IN; nothing for other words.
[[nodiscard]] std::optional<LengthUnit> unit_of_word(std::string_view word);

/// The length unit of a feed word (MMPM, MMPR, IPM, IPR, FPM, FPR); nothing for other words.
[[nodiscard]] std::optional<LengthUnit> unit_of_feed_word(std::string_view word);

}  // namespace gouge

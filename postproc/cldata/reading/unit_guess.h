#pragma once

#include <string_view>

#include "lib/base/units.h"
#include "postproc/cldata/language/dialect.h"

// The unit of a file's numbers, and where it comes from.

namespace gouge {

/// The unit a file's positions start in, and why.
struct UnitGuess {
  LengthUnit unit = LengthUnit::mm;
  enum class Source {
    stated,     ///< by UNITS or UNIT before the first position
    option,     ///< by the user
    feed_word,  ///< suggested by a word of FEDRAT or CYCLE (MMPM, IPM)
    dialect,    ///< the dialect's writer gives no unit and means mm
    assumed     ///< nothing says
  } source = Source::assumed;
};

/// UNITS or UNIT where the file states it before its first position, else what the feed words of FEDRAT and
/// CYCLE suggest, else what the dialect means, else mm.
[[nodiscard]] UnitGuess find_unit(std::string_view bytes, const Dialect& dialect);

}  // namespace gouge

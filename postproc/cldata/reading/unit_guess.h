#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "lib/base/units.h"
#include "postproc/cldata/language/statement.h"

namespace gouge {

/// The unit of a file's positions at its beginning, and how it is known.
struct UnitGuess {
  enum class Source {
    stated,     ///< by UNITS or UNIT before the first position
    option,     ///< by the user
    feed_word,  ///< by a word of FEDRAT or CYCLE (MMPM, IPM)
    none        ///< nothing states it: mm is taken
  };

  LengthUnit unit = LengthUnit::mm;
  Source source = Source::none;
  std::string word;      ///< the word in the file: "UNITS/MM", "MMPM"
  std::size_t line = 0;  ///< line of that word
};

/// Finds the unit of the positions.
///
/// Ensures  UNITS or UNIT before the first position decides; else the first feed word of FEDRAT or CYCLE.
/// Cost     The statements up to the first position, at most 20,000 if no unit is found before it.
[[nodiscard]] UnitGuess find_unit(std::string_view bytes, OpenStatements open);

}  // namespace gouge

#include "postproc/cldata/language/unit_words.h"

#include "postproc/cldata/language/text.h"

namespace gouge {

std::optional<LengthUnit> unit_of_word(std::string_view word) {
  for (const std::string_view mm : {"MM", "MMS", "MILLIMETER", "MILLIMETERS", "METRIC"}) {
    if (equals_ignoring_case(word, mm)) return LengthUnit::mm;
  }
  for (const std::string_view inch : {"IN", "INCH", "INCHES"}) {
    if (equals_ignoring_case(word, inch)) return LengthUnit::inch;
  }
  return std::nullopt;
}

std::optional<LengthUnit> unit_of_feed_word(std::string_view word) {
  for (const std::string_view mm : {"MMPM", "MMPR"}) {
    if (equals_ignoring_case(word, mm)) return LengthUnit::mm;
  }
  for (const std::string_view inch : {"IPM", "IPR", "FPM", "FPR"}) {
    if (equals_ignoring_case(word, inch)) return LengthUnit::inch;
  }
  return std::nullopt;
}

}  // namespace gouge

#pragma once

#include <cstddef>
#include <span>

#include "postproc/cldata/language/statement.h"
#include "postproc/cldata/language/words.h"

namespace gouge {

/// The lines in which feeds are first stated in mm and in inches (IPM, IPR, FPM, FPR), before any statement of the
/// unit. Positions of a file without such a statement are read in the unit of its feeds. 0: there is no such line.
class FeedUnits {
 public:
  void note(std::span<const Argument> arguments, std::size_t line) {
    if (is_closed_) return;
    for (const Argument& argument : arguments) {
      const std::optional<LengthUnit> unit = unit_of_feed_word(argument.text);
      if (!unit) continue;
      std::size_t& first = *unit == LengthUnit::mm ? in_mm_ : in_inches_;
      if (first == 0) first = line;
    }
  }
  /// Notes that a statement names the unit.
  void close() { is_closed_ = true; }

  [[nodiscard]] bool are_two() const { return in_mm_ > 0 && in_inches_ > 0; }
  [[nodiscard]] std::size_t in_mm() const { return in_mm_; }
  [[nodiscard]] std::size_t in_inches() const { return in_inches_; }

 private:
  std::size_t in_mm_ = 0, in_inches_ = 0;
  bool is_closed_ = false;
};

}  // namespace gouge

#pragma once

#include <string>
#include <string_view>

#include "lib/geom/pose.h"
#include "postproc/cldata/language/dialect.h"

// How each dialect writes numbers and positions when a file is written anew: its CAM system's own columns,
// digits and line ends, or more digits where the source file has more.

namespace gouge {

struct TextFormat {
  std::string_view go_to;      ///< up to the first number
  std::string_view separator;  ///< between numbers
  std::string_view rapid;
  std::string_view line_end;
  int decimals = 6, axis_decimals = 9;
  bool is_aligned = false;          ///< numbers in columns, blanks before them
  bool drops_zeros = false;         ///< ".5", "25.", "0"
  bool breaks_before_axis = false;  ///< i,j,k on a line of their own after a `$`
  bool always_has_axis = false;     ///< else only where it is not +Z (NX: where it changes)

  [[nodiscard]] std::string number(double value, int decimals) const;
  [[nodiscard]] std::string coordinate(double value) const { return number(value, decimals); }
  /// Three numbers, separated.
  [[nodiscard]] std::string point(const Vec3& value) const;
  [[nodiscard]] std::string direction(const Vec3& value) const;
};

[[nodiscard]] TextFormat text_format(DialectKind kind);

}  // namespace gouge

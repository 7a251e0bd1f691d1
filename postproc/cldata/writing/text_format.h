#pragma once

#include <string>
#include <string_view>

#include "lib/geom/pose.h"
#include "postproc/cldata/language/dialect.h"

// The text of each dialect: one row of words, columns, digits and line ends. They are those of its CAM system, with
// more digits if the source file has more.

namespace gouge {

/// Forms of statements. They contain names in braces, which TextSink replaces, and may have several lines. A line that
/// is empty after that is left out, and so is an empty form.
struct TextFormat {
  DialectKind kind = DialectKind::apt;
  std::string_view line_end = "\n";

  // Positions.
  std::string_view go_to = "GOTO/";  ///< text before the first number
  std::string_view go_to_end = {};   ///< text after the last number
  std::string_view separator = ",";  ///< between numbers
  int decimals = 6, axis_decimals = 9;
  bool is_aligned = false;            ///< numbers are in columns, with blanks before them
  bool drops_zeros = false;           ///< ".5", "25.", "0"
  bool breaks_before_axis = false;    ///< i,j,k are on a separate line after a `$`
  bool always_has_axis = false;       ///< if false, an axis is written only if it is not +Z (NX: if it changes)
  bool has_axis_when_tilted = false;  ///< every position has an axis if one of the path is not +Z; else none has

  std::string_view head = {};  ///< {name} {unit} {unit_once} {units_if_inch} {multax} {multax_if_tilted} {on_centre}
  std::string_view end = "FINI";
  std::string_view operation = {};       ///< {name} {featno} {on_centre}
  bool has_separate_operations = false;  ///< nothing is swept from one operation to the next
  std::string_view gohome = "GOHOME", cutcom = "CUTCOM/", rapid = "RAPID";
  std::string_view feed = "FEDRAT/{feed}, {unit}";  ///< {feed} {exact} {unit} {unit_after_turn} {per}
  int feed_decimals = 6;

  std::string_view circle = {};  ///< {center} {right} {left} {plus_z} {radius} {turn} {sense} {d} {r}
  bool has_tlon = false;         ///< circles are written as TLON of CATIA

  std::string_view tool_name = {};             ///< {name} or {certain_name}, which is certainly read as a name
  std::string_view cutter = "CUTTER/{seven}";  ///< {seven} {d}
  std::string_view cutter_separator = ", ";
  bool has_no_corner = false;                   ///< e and f of a straight cutter are written as 0
  std::string_view number = "LOADTL/{number}";  ///< {number} {d} {tprint}
  std::string_view flutes = {};                 ///< {flutes}

  [[nodiscard]] std::string number_text(double value, int decimals) const;
  [[nodiscard]] std::string coordinate(double value) const { return number_text(value, decimals); }
  /// Returns the three numbers with separators.
  [[nodiscard]] std::string point(const Vec3& value) const;
  [[nodiscard]] std::string direction(const Vec3& value) const;
};

[[nodiscard]] const TextFormat& text_format(DialectKind kind);

}  // namespace gouge

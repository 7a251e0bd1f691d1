#pragma once

#include <string>
#include <string_view>

#include "lib/geom/pose.h"
#include "postproc/cldata/language/dialect.h"

// Writing of each dialect: one row of words, columns, digits and line ends. They are those of its CAM system, or more
// digits where the source file has more.

namespace gouge {

/// Forms of statements hold names in braces, which TextSink fills. They may have several lines; one that is empty when
/// filled is left out, and so is a form that is empty.
struct TextFormat {
  DialectKind kind = DialectKind::apt;
  std::string_view line_end = "\n";

  // Positions.
  std::string_view go_to = "GOTO/";  ///< up to the first number
  std::string_view go_to_end = {};   ///< after the last one
  std::string_view separator = ",";  ///< between numbers
  int decimals = 6, axis_decimals = 9;
  bool is_aligned = false;            ///< numbers in columns, blanks before them
  bool drops_zeros = false;           ///< ".5", "25.", "0"
  bool breaks_before_axis = false;    ///< i,j,k on a line of their own after a `$`
  bool always_has_axis = false;       ///< else only where it is not +Z (NX: where it changes)
  bool has_axis_when_tilted = false;  ///< always where an axis of the path is not +Z, else never

  std::string_view head = {};  ///< {name} {unit} {unit_once} {units_if_inch} {multax} {multax_if_tilted} {on_centre}
  std::string_view end = "FINI";
  std::string_view operation = {};       ///< {name} {featno} {on_centre}
  bool has_separate_operations = false;  ///< nothing is swept from one to the next
  std::string_view gohome = "GOHOME", cutcom = "CUTCOM/", rapid = "RAPID";
  std::string_view feed = "FEDRAT/{feed}, {unit}";  ///< {feed} {exact} {unit} {unit_after_turn} {per}
  int feed_decimals = 6;

  std::string_view circle = {};  ///< {center} {right} {left} {plus_z} {radius} {turn} {sense} {d} {r}
  bool has_tlon = false;         ///< circles are CATIA's TLON

  std::string_view tool_name = {};             ///< {name}, {certain_name}: one that is read as a name
  std::string_view cutter = "CUTTER/{seven}";  ///< {seven} {d}
  std::string_view cutter_separator = ", ";
  bool has_no_corner = false;                   ///< e and f of a straight cutter are 0
  std::string_view number = "LOADTL/{number}";  ///< {number} {d} {tprint}
  std::string_view flutes = {};                 ///< {flutes}

  [[nodiscard]] std::string number_text(double value, int decimals) const;
  [[nodiscard]] std::string coordinate(double value) const { return number_text(value, decimals); }
  /// Returns three numbers, separated.
  [[nodiscard]] std::string point(const Vec3& value) const;
  [[nodiscard]] std::string direction(const Vec3& value) const;
};

[[nodiscard]] const TextFormat& text_format(DialectKind kind);

}  // namespace gouge

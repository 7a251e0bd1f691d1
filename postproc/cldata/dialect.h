#pragma once

#include <optional>
#include <string_view>

#include "lib/base/units.h"

// Which CAM system's way of writing CL data a file follows, told by its content. A dialect is data: a few
// facts the interpreter asks for. Evidence for each: docs/formats/apt_cl.md, nx_clsf.md.

namespace gouge {

enum class DialectKind { apt, nx_clsf, solidworks_cam, autodesk, camplete, catia, creo, nccs, clt, mori };

struct Dialect {
  DialectKind kind = DialectKind::apt;
  std::string_view id = "apt";  ///< Toolpath::dialect
  bool is_axis_modal = false;   ///< a position without axis keeps the last one; else it means +Z or TLAXIS
  bool has_known_plain_axis = false;  ///< verified that a position without axis means +Z whatever came before
  bool names_operations = false;      ///< has words of its own for it, so that PPRINT is only text
};

/// Looks at the first lines only. A file without the marks of any dialect is plain "apt".
[[nodiscard]] Dialect recognise_dialect(std::string_view bytes);

/// The unit a file's positions start in, and why.
struct UnitGuess {
  LengthUnit unit = LengthUnit::mm;
  enum class Source { stated, feed_word, assumed } source = Source::assumed;
};

/// UNITS or UNIT where the file states it before its first position, else what the words of FEDRAT suggest
/// (MMPM, IPM), else mm.
[[nodiscard]] UnitGuess find_unit(std::string_view bytes);

/// MM, MMS, MILLIMETERS, INCH, INCHES, IN; nothing for other words.
[[nodiscard]] std::optional<LengthUnit> unit_of_word(std::string_view word);

/// The length unit of a feed word (MMPM, MMPR, IPM, IPR, FPM, FPR); nothing for other words.
[[nodiscard]] std::optional<LengthUnit> unit_of_feed_word(std::string_view word);

}  // namespace gouge

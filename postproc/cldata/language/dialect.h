#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

// Which CAM system's way of writing CL data a file follows, told by its content or by the user. A dialect is
// data: a few facts the interpreter and the writers ask for. Evidence for each: docs/formats/.

namespace gouge {

enum class DialectKind : std::uint8_t {
  apt,
  nx_clsf,
  solidworks_cam,
  autodesk,
  camplete,
  catia,
  creo,
  nccs,
  clt,
  mori,
  goto_list,
  nccs_binary,
  nci
};

/// NCCS NCL, as text or in binary records: the same words.
[[nodiscard]] constexpr bool is_nccs(DialectKind kind) {
  return kind == DialectKind::nccs || kind == DialectKind::nccs_binary;
}

struct Dialect {
  DialectKind kind = DialectKind::apt;
  std::string_view id = "apt";             ///< Toolpath::dialect, and what --dialect takes
  std::string_view title = "APT CL data";  ///< for people
  bool is_axis_modal = false;  ///< a position without axis keeps the last one; else it means +Z or TLAXIS
  bool has_known_plain_axis = false;  ///< verified that a position without axis means +Z whatever came before
  bool names_operations = false;      ///< has words of its own for it, so that PPRINT is only text
  bool has_end_word = true;           ///< ends with END or FINI, so that a file without is cut short
};

/// All dialects, in the order they are listed for the user.
[[nodiscard]] std::span<const Dialect> all_dialects();

[[nodiscard]] const Dialect& dialect_of(DialectKind kind);

/// The dialect called `id`, upper or lower case, also without a leading "apt-"; nothing for other names.
[[nodiscard]] std::optional<Dialect> dialect_called(std::string_view id);

/// "nx-clsf, apt-catia, ...": what `dialect_called` takes.
[[nodiscard]] std::string dialect_names();

}  // namespace gouge

#include "postproc/gcode/language/control_table.h"

#include <algorithm>
#include <array>
#include <tuple>
#include <vector>

#include "lib/base/number_text.h"
#include "postproc/gcode/language/control_tables.h"

namespace gouge {

const GcodeRow* find_row(const ControlTable& control, char letter, CodeNumber number) {
  const auto key = [](const GcodeRow& row) { return std::tuple(row.letter, row.number); };
  const auto row = std::ranges::lower_bound(control.rows, std::tuple(letter, number), {}, key);
  return row != control.rows.end() && key(*row) == std::tuple(letter, number) ? &*row : nullptr;
}

const GcodeCycle* find_cycle(const ControlTable& control, CodeNumber number) {
  const auto row = std::ranges::find(control.cycles, number, &GcodeCycle::number);
  return row == control.cycles.end() ? nullptr : &*row;
}

std::span<const ControlTable* const> all_controls() {
  static const std::array<const ControlTable*, 3> all = {&linuxcnc_table(), &haas_table(), &fanuc_table()};
  return all;
}

const ControlTable* control_called(std::string_view id) {
  const auto is_same = [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a - 'A' + 'a' : a) == b; };
  for (const ControlTable* control : all_controls()) {
    if (std::ranges::equal(id, control->id, is_same)) return control;
  }
  return nullptr;
}

std::string control_names() {
  std::vector<std::string> names;
  for (const ControlTable* control : all_controls()) names.emplace_back(control->id);
  return listed(names, " or ");
}

}  // namespace gouge

#include "postproc/gcode/language/control_table.h"

#include <algorithm>
#include <tuple>

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

}  // namespace gouge

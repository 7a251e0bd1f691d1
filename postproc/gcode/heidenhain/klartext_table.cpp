#include "postproc/gcode/heidenhain/klartext_table.h"

#include <algorithm>
#include <array>

namespace gouge {
namespace {

using Meaning = KlartextMeaning;

constexpr std::array<KlartextFunction, 40> kFunctions = {{
    {0, Meaning::harmless},
    {1, Meaning::harmless},
    {2, Meaning::program_end},
    {3, Meaning::spindle_on},
    {4, Meaning::spindle_on},
    {5, Meaning::spindle_off},
    {6, Meaning::tool_change},
    {8, Meaning::harmless},
    {9, Meaning::harmless},
    {13, Meaning::spindle_on},
    {14, Meaning::spindle_on},
    {19, Meaning::spindle_off},
    {30, Meaning::program_end},
    {90, Meaning::not_checked_path, "corners are smoothed by an unknown distance"},
    {91, Meaning::machine_place},
    {92, Meaning::unknown_place},
    {99, Meaning::cycle_call},
    {103, Meaning::harmless},
    {107, Meaning::harmless},
    {108, Meaning::harmless},
    {109, Meaning::harmless},
    {110, Meaning::harmless},
    {111, Meaning::harmless},
    {112, Meaning::not_checked_path, "contour transitions are inserted"},
    {116, Meaning::harmless},
    {117, Meaning::harmless},
    {118, Meaning::not_checked_path, "the handwheel moves the tool"},
    {120, Meaning::not_checked_path, "the path with radius compensation looks ahead"},
    {124, Meaning::not_checked_path, "points are left out"},
    {126, Meaning::shortest_on},
    {127, Meaning::shortest_off},
    {128, Meaning::tip_control_on},
    {129, Meaning::tip_control_off},
    {130, Meaning::unknown_place},
    {134, Meaning::harmless},
    {135, Meaning::harmless},
    {136, Meaning::per_revolution},
    {137, Meaning::per_minute},
    {140, Meaning::retract},
    {145, Meaning::harmless},
}};

constexpr std::array<KlartextCycle, 11> kCycles = {{
    {200, KlartextDrilling::rapid_out, 395},
    {201, KlartextDrilling::feed_out},
    {202, KlartextDrilling::not_checked, 0, false, "boring moves across the hole"},
    {203, KlartextDrilling::rapid_out, 395},
    {204, KlartextDrilling::not_checked, 0, false, "back boring moves across the hole"},
    {205, KlartextDrilling::rapid_out, 395},
    {206, KlartextDrilling::feed_out},
    {207, KlartextDrilling::feed_out},
    {208, KlartextDrilling::not_checked, 0, false, "bore milling follows the radius of the tool"},
    {209, KlartextDrilling::feed_out},
    {240, KlartextDrilling::rapid_out, 343, true},
}};

template <typename Row, std::size_t count>
const Row* find_number(const std::array<Row, count>& rows, int number) {
  const auto found = std::ranges::find_if(rows, [&](const Row& row) { return row.number == number; });
  return found == rows.end() ? nullptr : &*found;
}

}  // namespace

const KlartextFunction* find_klartext_function(int number) { return find_number(kFunctions, number); }

const KlartextCycle* find_klartext_cycle(int number) { return find_number(kCycles, number); }

std::span<const KlartextFunction> klartext_functions() { return kFunctions; }
std::span<const KlartextCycle> klartext_cycles() { return kCycles; }

}  // namespace gouge

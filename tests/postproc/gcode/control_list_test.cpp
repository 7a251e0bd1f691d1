// Two lists know the codes of controls: the tables of programs, each of one control, and the list for text in CL data, which
// may be of any control. Where a table gives a code an effect, the list must not call it harmless.
#include "postproc/cldata/parsing/control_list.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "lib/base/number_text.h"
#include "lib/machine/machine.h"
#include "postproc/gcode/heidenhain/klartext_table.h"
#include "postproc/gcode/language/control_tables.h"
#include "postproc/gcode/reading/read_gcode.h"
#include "postproc/gcode/siemens/siemens_table.h"

namespace gouge::control_list_test {
namespace {

/// Returns the effects in CL data that stand for a meaning in a program; empty: only an unknown code does.
std::vector<ControlMeaning> effects_of(GcodeMeaning meaning) {
  using enum ControlMeaning;
  switch (meaning) {
    case GcodeMeaning::rapid:
    case GcodeMeaning::feed:
    case GcodeMeaning::arc_clockwise:
    case GcodeMeaning::arc_counterclockwise:
      return {path};
    case GcodeMeaning::no_motion:
      return {ends_cycle};
    case GcodeMeaning::cycle:
      return {begins_cycle};
    case GcodeMeaning::inch:
      return {inch};
    case GcodeMeaning::mm:
      return {mm};
    case GcodeMeaning::absolute:
      return {ends_steps};
    case GcodeMeaning::incremental:
      return {begins_steps};
    case GcodeMeaning::work_offset:
      return {offset};
    case GcodeMeaning::machine_place:
    case GcodeMeaning::home:
    case GcodeMeaning::align_to_plane:
      return {moves};
    case GcodeMeaning::length_on:
    case GcodeMeaning::length_off:
    case GcodeMeaning::tip_control_on:
      return {length};
    case GcodeMeaning::plane_xy:
    case GcodeMeaning::plane_zx:
    case GcodeMeaning::plane_yz:
      return {plane};
    case GcodeMeaning::centre_absolute:
      return {centres_absolute};
    case GcodeMeaning::centre_incremental:
      return {centres_from_start};
    case GcodeMeaning::cycle_to_start:
    case GcodeMeaning::cycle_to_plane:
      return {level};
    case GcodeMeaning::blending:
      return {smooths, blends};
    case GcodeMeaning::tilted_plane_off:
    case GcodeMeaning::turned_offset_off:
      return {ends_tilt};
    case GcodeMeaning::tilted_plane:
      return {shifts};
    case GcodeMeaning::tool_change:
      return {changes_tool};
    case GcodeMeaning::program_end:
      return {ends_program};
    case GcodeMeaning::not_checked:
      return {shifts, shifts_with_axes, length, moves};
    case GcodeMeaning::turned_offset_on:
    case GcodeMeaning::call_program:
    case GcodeMeaning::call_block:
    case GcodeMeaning::return_from_call:
      return {};
    default:
      return {harmless};  // what ends a frame ends one that the list did not take for harmless
  }
}

TEST(ControlList, CallsNoCodeHarmlessToWhichAControlGivesAnEffect) {
  for (const ControlTable* control : {&linuxcnc_table(), &haas_table(), &fanuc_table()}) {
    for (const GcodeRow& row : control->rows) {
      const auto listed = find_control_code(row.letter, row.number / 10.0);
      if (listed.empty()) continue;  // unknown: nothing after it is checked
      const std::vector<ControlMeaning> effects = effects_of(row.meaning);
      const bool is_known = std::ranges::any_of(listed, [&](const ControlCode* one) {
        return std::ranges::find(effects, one->meaning) != effects.end() ||
               (effects == std::vector{ControlMeaning::harmless} && one->meaning != ControlMeaning::harmless);
      });
      EXPECT_TRUE(is_known) << control->id << " " << row.letter << row.number / 10.0;
    }
  }
}

/// Returns whether text in CL data may have an effect by this code, or is not understood.
bool is_no_harmless_code(char letter, double number) {
  const auto listed = find_control_code(letter, number);
  const auto has_effect = [](const ControlCode* one) { return one->meaning != ControlMeaning::harmless; };
  return listed.empty() || std::ranges::any_of(listed, has_effect);
}

TEST(ControlList, CallsNoPlaceOfSiemensHarmless) {
  for (const SiemensRow& row : siemens_rows()) {
    using enum SiemensMeaning;
    const bool has_effect = row.meaning == machine_axes || row.meaning == basic_axes || row.meaning == work_offset ||
                            row.meaning == leave_to_fixed_point || row.meaning == not_checked;
    const auto number = parse_number(row.name.substr(1));
    if (!has_effect) continue;
    const bool is_listed_harmless =
        number ? row.name[0] == 'G' && !is_no_harmless_code('G', *number) : find_control_word(row.name) != nullptr;
    EXPECT_FALSE(is_listed_harmless) << row.name;
  }
}

TEST(ControlList, CallsNoMotionOfHeidenhainHarmless) {
  for (const KlartextFunction& row : klartext_functions()) {
    using enum KlartextMeaning;
    const bool has_effect = row.meaning == machine_place || row.meaning == unknown_place || row.meaning == retract ||
                            row.meaning == tool_change || row.meaning == cycle_call || row.meaning == tip_control_off ||
                            row.meaning == not_checked_path || row.meaning == program_end;
    EXPECT_TRUE(!has_effect || is_no_harmless_code('M', row.number)) << row.number;
  }
}

TEST(ControlList, MachineFilesNameTheLanguagesThatAreRead) {
  std::vector<std::string> read;
  for (const ProgramLanguage& language : all_languages()) read.emplace_back(language.id);
  EXPECT_EQ(read, kProgramLanguages);
}

}  // namespace
}  // namespace gouge::control_list_test

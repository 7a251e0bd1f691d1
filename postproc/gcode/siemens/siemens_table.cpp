#include "postproc/gcode/siemens/siemens_table.h"

#include <algorithm>
#include <array>

#include "lib/base/number_text.h"

// Sources: docs/formats/gcode_siemens.md.

namespace gouge {
namespace {

using enum SiemensMeaning;
using SGroup = SiemensGroup;

constexpr std::string_view kCompensated = "the path is compensated by the radius of the tool";

constexpr auto kSiemensRows = std::to_array<SiemensRow>({
    {"G0", rapid, SGroup::motion},
    {"G1", line, SGroup::motion},
    {"G2", arc_clockwise, SGroup::motion},
    {"G3", arc_counterclockwise, SGroup::motion},
    {"CIP", arc_by_point, SGroup::motion},
    {"G4", dwell, SGroup::none, true},
    {"G9", harmless},
    {"G17", plane_xy, SGroup::plane},
    {"G18", plane_zx, SGroup::plane},
    {"G19", plane_yz, SGroup::plane},
    {"G40", compensation_off, SGroup::compensation},
    {"G41", not_checked, SGroup::compensation, false, false, false, kCompensated},
    {"G42", not_checked, SGroup::compensation, false, false, false, kCompensated},
    {"G53", basic_axes, SGroup::suppression},
    {"G153", machine_axes, SGroup::suppression},
    {"SUPA", machine_axes, SGroup::suppression},
    {"G500", work_offset, SGroup::work_offset},
    {"G54", work_offset, SGroup::work_offset},
    {"G55", work_offset, SGroup::work_offset},
    {"G56", work_offset, SGroup::work_offset},
    {"G57", work_offset, SGroup::work_offset},
    {"G505", work_offset, SGroup::work_offset},
    {"G60", exact_path, SGroup::path_control},
    {"G64", smooth_path, SGroup::path_control},
    {"G641", smooth_distance, SGroup::path_control},
    {"G642", smooth_tolerance, SGroup::path_control},
    {"G643", smooth_tolerance, SGroup::path_control},
    {"G644", smooth_path, SGroup::path_control},
    {"G645", smooth_path, SGroup::path_control},
    {"G601", harmless},
    {"G602", harmless},
    {"G603", harmless},
    {"G70", inch, SGroup::unit},
    {"G700", inch, SGroup::unit},
    {"G71", mm, SGroup::unit},
    {"G710", mm, SGroup::unit},
    {"G74", leave_to_fixed_point},
    {"G75", leave_to_fixed_point},
    {"G90", absolute, SGroup::distance},
    {"G91", incremental, SGroup::distance},
    {"G93", feed_inverse, SGroup::feed},
    {"G94", feed_per_minute, SGroup::feed},
    {"G95", feed_per_revolution, SGroup::feed},
    {"COMPOF", compressor_off, SGroup::compressor},
    {"COMPON", compressor_on, SGroup::compressor},
    {"COMPCURV", compressor_on, SGroup::compressor},
    {"COMPCAD", compressor_on, SGroup::compressor},
    {"COMPSURF", compressor_on, SGroup::compressor},
    {"RTLION", rapid_straight, SGroup::rapid_kind},
    {"RTLIOF", rapid_apart, SGroup::rapid_kind},
    {"ORIWKS", turn_by_vector, SGroup::turn_frame},
    {"ORIMKS", turn_by_axis, SGroup::turn_frame},
    {"ORIVECT", turn_by_vector, SGroup::turn_path},
    {"ORIPLANE", turn_by_vector, SGroup::turn_path},
    {"ORIAXES", turn_by_axis, SGroup::turn_path},
    {"TRAORI", tip_control_on, SGroup::transformation, true, true},
    {"TRAFOOF", tip_control_off, SGroup::transformation, true, true},
    {"TRANS", translate, SGroup::frame, true},
    {"ATRANS", translate, SGroup::frame, true, false, true},
    {"ROT", rotate, SGroup::frame, true},
    {"AROT", rotate, SGroup::frame, true, false, true},
    {"SCALE", scale, SGroup::frame, true},
    {"ASCALE", scale, SGroup::frame, true, false, true},
    {"MIRROR", mirror, SGroup::frame, true},
    {"AMIRROR", mirror, SGroup::frame, true, false, true},
    {"CYCLE800", swivel, SGroup::frame, true, true},
    {"CYCLE832", smoothing, SGroup::path_control, true, true},
    {"MCALL", modal_call, SGroup::none, true},
    {"CYCLE81", drill, SGroup::none, true, true},
    {"CYCLE82", drill, SGroup::none, true, true},
    {"CYCLE83", drill, SGroup::none, true, true},
    {"CYCLE84", drill, SGroup::none, true, true},
    {"CYCLE840", drill, SGroup::none, true, true},
    {"CYCLE85", drill, SGroup::none, true, true},
    {"CYCLE86", drill, SGroup::none, true, true},
    {"CYCLE87", drill, SGroup::none, true, true},
    {"CYCLE88", drill, SGroup::none, true, true},
    {"CYCLE89", drill, SGroup::none, true, true},
    {"MSG", message, SGroup::none, false, true},
    {"SETMS", harmless, SGroup::none, false, true},
    {"WORKPIECE", harmless, SGroup::none, true, true},
    {"FGROUP", harmless, SGroup::none, false, true},
    {"FNORM", harmless},
    {"FLIN", harmless},
    {"FCUB", harmless},
    {"FFWON", harmless},
    {"FFWOF", harmless},
    {"SOFT", harmless},
    {"BRISK", harmless},
    {"DRIVE", harmless},
    {"CFC", harmless},
    {"CFIN", harmless},
    {"CFTCP", harmless},
    {"UPATH", harmless},
    {"SPATH", harmless},
    {"DYNNORM", harmless},
    {"DYNPOS", harmless},
    {"DYNROUGH", harmless},
    {"DYNSEMIFIN", harmless},
    {"DYNFINISH", harmless},
    {"STOPRE", harmless},
    {"STARTFIFO", harmless},
    {"STOPFIFO", harmless},
    {"FIFOCTRL", harmless},
    {"M0", harmless},
    {"M1", harmless},
    {"M2", program_end},
    {"M3", spindle_on},
    {"M4", spindle_on},
    {"M5", spindle_off},
    {"M6", tool_change, SGroup::none, true},
    {"M7", harmless},
    {"M8", harmless},
    {"M9", harmless},
    {"M17", back},
    {"M19", spindle_off},
    {"M30", program_end},
    {"M40", harmless},
    {"M41", harmless},
    {"M42", harmless},
    {"M43", harmless},
    {"M44", harmless},
    {"M45", harmless},
});

// RTP, RFP, SDIS, DP and DPR come first in all of them.
constexpr auto kSiemensCycles = std::to_array<SiemensCycle>({
    {"CYCLE81", DrillForm::feed_in_rapid_out, 6},
    {"CYCLE82", DrillForm::feed_in_rapid_out, 6},
    {"CYCLE83", DrillForm::feed_in_rapid_out, 12},
    {"CYCLE84", DrillForm::thread, 12},
    {"CYCLE840", DrillForm::thread, 11},
    {"CYCLE85", DrillForm::feed_in_feed_out, 8},
    {"CYCLE86", DrillForm::not_checked, 11},
    {"CYCLE87", DrillForm::feed_in_rapid_out, 6},
    {"CYCLE88", DrillForm::feed_in_rapid_out, 7},
    {"CYCLE89", DrillForm::feed_in_feed_out, 6},
});

constexpr auto kHarmlessValues = std::to_array<std::string_view>({"S", "S1", "SPOS", "LIMS", "FB", "M1"});

}  // namespace

std::span<const SiemensRow> siemens_rows() { return kSiemensRows; }

const SiemensRow* find_siemens_row(std::string_view name) {
  constexpr int kFirstOffset = 505, kLastOffset = 599;
  const auto number = name.size() == 4 && name[0] == 'G' ? parse_integer(name.substr(1)) : std::nullopt;
  if (number && *number >= kFirstOffset && *number <= kLastOffset) name = "G505";
  const auto row = std::ranges::find(kSiemensRows, name, &SiemensRow::name);
  return row == kSiemensRows.end() ? nullptr : &*row;
}

const SiemensCycle* find_siemens_cycle(std::string_view name) {
  const auto cycle = std::ranges::find(kSiemensCycles, name, &SiemensCycle::name);
  return cycle == kSiemensCycles.end() ? nullptr : &*cycle;
}

bool is_harmless_value(std::string_view name) {
  return std::ranges::find(kHarmlessValues, name) != kHarmlessValues.end();
}

}  // namespace gouge

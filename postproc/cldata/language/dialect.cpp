#include "postproc/cldata/language/dialect.h"

#include <algorithm>
#include <array>

#include "postproc/cldata/language/text.h"

namespace gouge {
namespace {

using enum ArcSense;

// NCCS NCL, whose binary records have the same words as its text.
constexpr Dialect kNccs = {.kind = DialectKind::nccs,
                           .id = "apt-nccs",
                           .title = "NCCS NCL CL data (ASCII)",
                           .states_multax = true,
                           .lists_run_along_arc = true,
                           .may_go_on_round = true,
                           .gohome_names_axes = false,
                           .pprint_includes_files = true,
                           .arc_form = ArcForm::ncl,
                           .arc_rule = ArcRule::shorter_path,
                           .cycle_form = CycleForm::ncl};

constexpr Dialect in_records(Dialect dialect) {
  dialect.kind = DialectKind::nccs_binary;
  dialect.id = "nccs-binary";
  dialect.title = "NCCS NCL CL data (binary)";
  dialect.format = "nccs-records";
  dialect.is_binary = true;
  dialect.has_apt_words = false;
  dialect.cut_statement = "the file ends within this record, or the record has no length: it is cut short or damaged";
  dialect.no_position = "is a binary NCCS file without a position; expected motion records";
  dialect.has_points_at_multax_off = true;
  dialect.may_go_on_round = false;
  dialect.cutter_form = CutterForm::without_angles;
  return dialect;
}

constexpr std::array<Dialect, 13> kDialects = {{
    {.kind = DialectKind::nx_clsf,
     .id = "nx-clsf",
     .title = "Siemens NX CLSF",
     .has_end_word = false,
     .is_axis_modal = true,
     .names_operations = true,
     .has_blocks = true,
     .has_named_tools = true,
     .states_whole_length = true,
     .arc_sense = left_handed,
     .cycle_form = CycleForm::nx,
     .feed_in_cycle = FeedInCycle::nowhere,
     .cutter_form = CutterForm::with_diameter},
    {.kind = DialectKind::catia,
     .id = "apt-catia",
     .title = "CATIA V5 APT source",
     .comments = CommentForm::catia,
     .locks_axis = true,
     .names_operations = true,
     .cycle_form = CycleForm::catia,
     .feed_in_cycle = FeedInCycle::nowhere},
    {.kind = DialectKind::creo,
     .id = "apt-creo",
     .title = "PTC Creo (Pro/CLfile) NCL",
     .comments = CommentForm::creo,
     .has_known_plain_axis = true,
     .states_multax = true,
     .has_points_without_axis = true,
     .lists_run_along_arc = true,
     .names_operations = true,
     .has_camera_csys = true,
     .arc_sense = right_handed,
     .has_flat_circles = true,
     .cycle_form = CycleForm::creo,
     .feed_in_cycle = FeedInCycle::nowhere,
     .cutter_form = CutterForm::diameter_alone},
    {.kind = DialectKind::solidworks_cam,
     .id = "apt-solidworks-cam",
     .title = "SolidWorks CAM / CAMWorks APT",
     .has_known_plain_axis = true,
     .names_operations = true,
     .is_in_world = true,
     .inserts_are_names = true,
     .states_whole_length = true,
     .arc_sense = right_handed,
     .cycle_form = CycleForm::depths,
     .feed_in_cycle = FeedInCycle::nowhere},
    {.kind = DialectKind::clt,
     .id = "camworks-clt",
     .title = "CAMWorks CLT",
     .has_known_plain_axis = true,
     .names_operations = true,
     .has_setups = true,
     .has_z_alone = true,
     .cycle_form = CycleForm::clt,
     .feed_in_cycle = FeedInCycle::nowhere},
    {.kind = DialectKind::autodesk,
     .id = "apt-autodesk",
     .title = "Autodesk ISO 4343 APT",
     .has_known_plain_axis = true,
     .has_axes_under_multax = true,
     .has_tip_diameter = true,
     .arc_sense = right_handed,
     .arc_rule = ArcRule::by_vector_or_against,
     .cycle_form = CycleForm::unknown,
     .feed_in_cycle = FeedInCycle::anywhere},
    {.kind = DialectKind::camplete,
     .id = "apt-camplete",
     .title = "CAMplete APT",
     .has_known_plain_axis = true,
     .has_axes_under_multax = true,
     .names_operations = true,
     .operations_are_blocks = true,
     .has_tool_angles = false,
     .arc_form = ArcForm::with_sweep,
     .arc_sense = left_handed,
     .cycle_form = CycleForm::depths_without_rapto,
     .feed_in_cycle = FeedInCycle::anywhere},
    {.kind = DialectKind::mori,
     .id = "apt-mori",
     .title = "DMG Mori APT",
     .has_axes_under_multax = true,
     .names_operations = true,
     .arc_sense = right_handed,
     .cycle_form = CycleForm::creo,
     .feed_in_cycle = FeedInCycle::anywhere,
     .cutter_form = CutterForm::none},
    kNccs,
    in_records(kNccs),
    {.kind = DialectKind::nci,
     .id = "mastercam-nci",
     .title = "Mastercam NCI",
     .format = "nci-lines",
     .has_apt_words = false,
     .end_name = "a line 1003",
     .cut_statement = "the file ends after a code; expected the line of its parameters: the file is cut short",
     .names_operations = true,
     .arc_form = ArcForm::nci,
     .cycle_form = CycleForm::unknown,
     .feed_in_cycle = FeedInCycle::anywhere,
     .is_written = false},
    {.kind = DialectKind::goto_list,
     .id = "goto-list",
     .title = "bare GOTO lines",
     .has_end_word = false,
     .has_positions_alone = true,
     .cutter_form = CutterForm::none},
    {.kind = DialectKind::apt, .id = "apt", .title = "APT CL data", .has_end_word = false, .is_fallback = true},
}};

constexpr Dialect kGcode = {.kind = DialectKind::gcode,
                            .id = "gcode",
                            .title = "G-code",
                            .format = "gcode",
                            .has_apt_words = false,
                            .is_written = false};

}  // namespace

const Dialect& gcode_dialect() { return kGcode; }

std::span<const Dialect> all_dialects() { return kDialects; }

const Dialect& dialect_of(DialectKind kind) {
  if (kind == DialectKind::gcode) return kGcode;
  const auto* const it = std::ranges::find_if(kDialects, [&](const Dialect& d) { return d.kind == kind; });
  return it == kDialects.end() ? kDialects.back() : *it;
}

std::optional<Dialect> dialect_called(std::string_view id) {
  constexpr std::string_view kApt = "apt-";
  for (const Dialect& dialect : kDialects) {
    const bool is_short = dialect.id.starts_with(kApt) && equals_ignoring_case(id, dialect.id.substr(kApt.size()));
    if (is_short || equals_ignoring_case(id, dialect.id)) return dialect;
  }
  if (equals_ignoring_case(id, kGcode.id)) return kGcode;
  return std::nullopt;
}

Dialect dialect_or_apt(std::string_view id) { return dialect_called(id).value_or(Dialect{}); }

namespace {

std::string names_of(bool is_written_only) {
  std::string names;
  for (const Dialect& dialect : kDialects) {
    if (dialect.is_written || !is_written_only) names += (names.empty() ? "" : ", ") + std::string(dialect.id);
  }
  return is_written_only ? names : names + ", " + std::string(kGcode.id);
}

}  // namespace

std::string dialect_names() { return names_of(false); }

std::string writable_dialect_names() { return names_of(true); }

}  // namespace gouge

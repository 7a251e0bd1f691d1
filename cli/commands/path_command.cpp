#include "cli/commands/path_command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <optional>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>

#include "cli/job/scene_files.h"
#include "cli/machine/rapid_notes.h"
#include "cli/options/command_doc.h"
#include "cli/options/job_options.h"
#include "cli/output/json_text.h"
#include "cli/output/output_file.h"
#include "cli/terminal/length_text.h"
#include "cli/terminal/print_diagnostics.h"
#include "cli/terminal/progress.h"
#include "cli/terminal/terminal.h"
#include "lib/base/exit_code.h"
#include "lib/base/files.h"
#include "lib/base/number_text.h"
#include "lib/base/printable_text.h"
#include "lib/path/path_info.h"
#include "postproc/formats/write_toolpath.h"
#include "postproc/image/path_plot.h"

namespace gouge {
namespace {

// Functions for the output of `path info`, as text and as JSON. Lengths are in the unit of the file.

constexpr std::size_t kPathLabelWidth = 22;
constexpr int kShownDecimals = 4;

std::string path_row(const std::string& name, const std::string& value) {
  return padded(name, kPathLabelWidth - 1) + " " + printable(value) + "\n";
}

/// Returns rows with their values broken at blanks, for a terminal of `columns`; 0: as they are.
std::string wrapped_rows(const std::string& rows, std::size_t columns) {
  constexpr std::size_t kMinValueWidth = 20;
  if (columns < kPathLabelWidth + kMinValueWidth) return rows;
  std::string text;
  std::istringstream lines(rows);
  for (std::string line; std::getline(lines, line);) {
    if (display_width(line) <= columns) {
      text += line + "\n";
      continue;
    }
    std::istringstream values(wrapped(line.substr(kPathLabelWidth), columns - kPathLabelWidth, 0));
    std::string label = line.substr(0, kPathLabelWidth);
    for (std::string value; std::getline(values, value); label = std::string(kPathLabelWidth, ' '))
      text += label + value + "\n";
  }
  return text;
}

std::string shown(double value) { return display_text(value, kShownDecimals); }

std::string shown(const Vec3& point, double mm_per_unit) {
  return shown(point.x() / mm_per_unit) + ", " + shown(point.y() / mm_per_unit) + ", " + shown(point.z() / mm_per_unit);
}

std::string tool_title(const PathTool& tool) {
  return tool.number ? "T" + std::to_string(*tool.number) : std::string("unnumbered");
}

std::string cutter_text(const PathTool& tool, double mm_per_unit) {
  if (!tool.cutter) return "cutter not stated: give a tool library";
  const CutterStatement& cutter = *tool.cutter;
  std::string text = "D " + shown(cutter.d_mm / mm_per_unit) + "  R " + shown(cutter.r_mm / mm_per_unit);
  const bool is_plain = std::max(cutter.alpha_deg, std::max(cutter.beta_deg, -cutter.beta_deg)) <= 0;
  if (!is_plain) text += "  tip angle " + shown(cutter.alpha_deg) + "  flank angle " + shown(cutter.beta_deg);
  if (cutter.h_mm > 0) text += "  length " + shown(cutter.h_mm / mm_per_unit);
  if (tool.flute_length_mm > 0) text += "  flutes " + shown(tool.flute_length_mm / mm_per_unit);
  return text;
}

std::string moves_text(const PathInfo& info) {
  std::string text;
  for (const MoveKind kind : {MoveKind::feed, MoveKind::rapid, MoveKind::arc, MoveKind::cycle}) {
    const std::size_t count = info.moves_by_kind[static_cast<std::size_t>(kind)];
    if (count == 0) continue;
    text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + kind_name(kind);
  }
  return text;
}

std::string tools_text(const Toolpath& path, const PathInfo& info, double mm_per_unit) {
  std::string text;
  for (std::size_t i = 0; i < path.tools.size(); ++i) {
    const PathTool& tool = path.tools[i];
    text += path_row("tool " + tool_title(tool), cutter_text(tool, mm_per_unit) + "  (" +
                                                     count_text(info.moves_of_tool[i], "move") + ", line " +
                                                     std::to_string(tool.line) + ")");
    if (!tool.name.empty()) text += path_row("", tool.name);
  }
  if (info.moves_without_tool > 0) text += path_row("no tool named", count_text(info.moves_without_tool, "move"));
  for (std::size_t i = 0; i < path.operations.size(); ++i) {
    const Operation& operation = path.operations[i];
    text += path_row(i == 0 ? "operations" : "", (operation.name.empty() ? "(no name)" : operation.name) + "  (" +
                                                     count_text(info.moves_of_operation[i], "move") + ", line " +
                                                     std::to_string(operation.line) + ")");
  }
  return text;
}

std::string uncertainties_text(const Toolpath& path, const PathInfo& info) {
  std::size_t count = 0;
  for (const auto& reason : info.not_checkable) count += reason.second;
  std::string text = path_row("cannot be checked", count == 0 ? "none" : count_text(count, "move"));
  for (const auto& [reason, moves] : info.not_checkable) text += path_row("", std::to_string(moves) + ": " + reason);
  if (path.words_not_understood.empty()) return text + path_row("words not understood", "none");
  std::string words;
  for (const auto& [word, times] : path.words_not_understood) {
    words += (words.empty() ? "" : ", ") + word + " " + std::to_string(times);
  }
  return text + path_row("words not understood", words);
}

Json tool_json(const PathTool& tool, std::size_t moves, double mm_per_unit) {
  Json json;
  json["number"] = tool.number ? Json(*tool.number) : Json(nullptr);
  json["name"] = tool.name;
  json["line"] = tool.line;
  json["moves"] = moves;
  if (tool.flute_length_mm > 0) json["flute_length"] = tool.flute_length_mm / mm_per_unit;
  if (!tool.cutter) return json;
  const CutterStatement& cutter = *tool.cutter;
  json["cutter"] = {{"d", cutter.d_mm / mm_per_unit}, {"r", cutter.r_mm / mm_per_unit},
                    {"e", cutter.e_mm / mm_per_unit}, {"f", cutter.f_mm / mm_per_unit},
                    {"alpha", cutter.alpha_deg},      {"beta", cutter.beta_deg},
                    {"h", cutter.h_mm / mm_per_unit}};
  return json;
}

std::string orientations_text(const Toolpath& path, const PathInfo& info) {
  std::string text = std::to_string(info.orientations);
  if (path.moves.empty()) return text;
  const std::string first = shown(path.moves.front().end.axis, 1);
  if (info.largest_tilt_move == kNone) return text + ": the tool axis is " + first + " at all positions";
  return text + ": the first tool axis is " + first + ", the largest tilt from it " + shown(info.largest_tilt_deg) +
         " degrees in line " + std::to_string(path.moves[info.largest_tilt_move].line);
}

std::string path_info_text(const Toolpath& path, const PathInfo& info, const std::string& dialect_title) {
  const double mm_per_unit = mm_per(path.unit);
  const std::string unit = unit_name(path.unit);
  std::string text = path_row("file", path.file);
  text += path_row("dialect", path.dialect + " (" + dialect_title + ")");
  text += path_row("unit", unit + (path.is_unit_stated ? " (stated)" : " (not stated)"));
  text += path_row("moves", std::to_string(path.moves.size()) + ": " + moves_text(info));
  text += path_row("positions alone", std::to_string(info.alone) + " (no known motion leads to them)");
  if (!info.box.isEmpty()) {
    text += path_row("box from", shown(info.box.min(), mm_per_unit) + " " + unit);
    text += path_row("box to", shown(info.box.max(), mm_per_unit) + " " + unit);
  }
  text += path_row("length", shown(info.feed_length_mm / mm_per_unit) + " " + unit + " feed, " +
                                 shown(info.rapid_length_mm / mm_per_unit) + " " + unit + " rapid");
  text += path_row("orientations", orientations_text(path, info));
  if (info.largest_turn_move != kNone) {
    text += path_row("largest turn", shown(info.largest_turn_deg) + " degrees in move " +
                                         std::to_string(info.largest_turn_move) + ", line " +
                                         std::to_string(path.moves[info.largest_turn_move].line));
  }
  return text + tools_text(path, info, mm_per_unit) + uncertainties_text(path, info);
}

std::string path_info_json(const Toolpath& path, const PathInfo& info) {
  const double mm_per_unit = mm_per(path.unit);
  Json json;
  json["file"] = path.file;
  json["dialect"] = path.dialect;
  json["unit"] = path.unit == LengthUnit::inch ? "inch" : "mm";
  json["unit_stated"] = path.is_unit_stated;
  json["moves"] = path.moves.size();
  for (const MoveKind kind : {MoveKind::feed, MoveKind::rapid, MoveKind::arc, MoveKind::cycle}) {
    json["moves_by_kind"][kind_name(kind)] = info.moves_by_kind[static_cast<std::size_t>(kind)];
  }
  json["positions_alone"] = info.alone;
  if (!info.box.isEmpty()) {
    json["box"] = {{"from", point_json(info.box.min(), mm_per_unit)}, {"to", point_json(info.box.max(), mm_per_unit)}};
  }
  json["feed_length"] = info.feed_length_mm / mm_per_unit;
  json["rapid_length"] = info.rapid_length_mm / mm_per_unit;
  json["orientations"] = info.orientations;
  if (!path.moves.empty()) json["first_axis"] = point_json(path.moves.front().end.axis, 1);
  json["largest_tilt_deg"] = info.largest_tilt_deg;
  if (info.largest_tilt_move != kNone) json["largest_tilt_line"] = std::size_t{path.moves[info.largest_tilt_move].line};
  json["largest_turn_deg"] = info.largest_turn_deg;
  if (info.largest_turn_move != kNone) json["largest_turn_line"] = std::size_t{path.moves[info.largest_turn_move].line};
  json["tools"] = Json::array();
  for (std::size_t i = 0; i < path.tools.size(); ++i) {
    json["tools"].push_back(tool_json(path.tools[i], info.moves_of_tool[i], mm_per_unit));
  }
  json["moves_without_tool"] = info.moves_without_tool;
  json["operations"] = Json::array();
  for (std::size_t i = 0; i < path.operations.size(); ++i) {
    json["operations"].push_back(
        {{"name", path.operations[i].name}, {"line", path.operations[i].line}, {"moves", info.moves_of_operation[i]}});
  }
  json["not_checkable"] = Json::object();
  for (const auto& [reason, moves] : info.not_checkable) json["not_checkable"][reason] = moves;
  json["words_not_understood"] = Json::object();
  for (const auto& [word, times] : path.words_not_understood) json["words_not_understood"][word] = times;
  return json_text(json);
}

int run_info(const PathArguments& arguments, const Toolpath& path, std::ostream& out, std::ostream& err) {
  const PathInfo info = describe_path(path);
  const Dialect dialect = dialect_or_apt(path.dialect);
  const std::string title(dialect.title);
  Outcome written = Done{};
  if (!arguments.json_file.empty()) written = write_output(arguments.json_file, path_info_json(path, info), out);
  if (arguments.json_file != "-") out << wrapped_rows(path_info_text(path, info, title), terminal_columns(out));
  print(err, path.notes);
  return written ? kExitClean : fail(err, {written.error()}, kExitInternal);
}

// Returns warnings of the facts of a file that are not established, and that its copy in another dialect does not state.
Diagnostics find_lost_facts(const Toolpath& path) {
  Assumptions facts = path.assumptions;
  std::erase_if(facts, [](const Assumption& fact) { return fact.subject == Subject::statements; });  // notes name them
  settle(facts, {}, false);
  Diagnostics lost = open_warnings(facts);
  const auto add = [&](std::size_t line, const std::string& what) {
    const std::string text = "text for the control in line " + std::to_string(line) + " is left out: " + what;
    if (line > 0) lost.push_back(make_warning("convert-control", text, path.file, line));
  };
  add(path.smoothing_line, "it lets the tool leave the path; check the output with --tip-tolerance");
  add(path.joint_law_line, "the rotary joints run in proportion; check the output with --machine and --feed-law axis");
  return lost;
}

int run_convert(const PathArguments& arguments, const Toolpath& path, const Machine* machine, std::ostream& out,
                std::ostream& err) {
  Result<WrittenToolpath> written = WrittenToolpath{std::string(path.source.view()), {}};
  if (!arguments.to.empty()) written = write_toolpath(path, *dialect_called(arguments.to));
  if (!written) return fail(err, {written.error()});
  print(err, path.notes);
  print(err, written->notes);
  if (!arguments.to.empty()) print(err, find_lost_facts(path));
  if (machine != nullptr && !arguments.to.empty()) print(err, find_lost_rapids(*machine, path));
  const Outcome outcome = write_output(arguments.output, written->bytes, out);
  return outcome ? kExitClean : fail(err, {outcome.error()}, kExitInternal);
}

int run_plot(const PathArguments& arguments, const RigidTransform& place, const Toolpath& path, bool is_svg,
             std::ostream& err) {
  print(err, path.notes);
  const LengthUnit unit = unit_called(arguments.stl_units).value_or(path.unit);
  Progress progress(err, ProgressMode::automatic);
  const auto scene =
      load_scene({arguments.parts, {}, {}, unit, place, arguments.place, arguments.input.max_bytes, 0}, progress);
  progress.end();
  if (!scene->errors.empty()) return fail(err, scene->errors);
  if (!is_svg) print(err, find_missing_letters(path));
  const Result<std::string> picture = plot_path(path, scene->scene.parts, is_svg);
  if (!picture) return fail(err, {picture.error()}, kExitInternal);
  const Outcome outcome = write_file(arguments.output, *picture);
  return outcome ? kExitClean : fail(err, {outcome.error()}, kExitInternal);
}

constexpr const char* kStatus =
    "Exit status: 0 done, 2 wrong command line, 3 input unreadable or invalid, 5 output unwritable.";

/// Returns the error of a name for --to, or an empty text.
std::string why_not_writable(const std::string& name) {
  const std::optional<Dialect> dialect = dialect_called(name);
  if (dialect && dialect->is_written) return {};
  return "expected one of " + writable_dialect_names() +
         (dialect ? "; " + std::string(dialect->id) + " can be read but not written"
                  : "; programs of a control (G-code) are not written");
}

CLI::App& add_command(CLI::App& command, PathArguments& arguments, const char* name, const char* what) {
  CLI::App* added = command.add_subcommand(name, what);
  added->add_option("PATH", arguments.path, "Toolpath: CL data of any dialect, recognized by its content")
      ->type_name("FILE")
      ->required();
  add_program_reading(*added, arguments, MachineOption::possible);
  return *added;
}

}  // namespace

void add_path_options(CLI::App& command, PathArguments& arguments) {
  command.require_subcommand(1);
  command.footer(
      "Example:\n"
      "  gougecheck path info finish.apt\n\n"
      "Dialects that can be read: " +
      dialect_names());
  CLI::App& info =
      add_command(command, arguments, "info",
                  "Show dialect, unit, tools, operations, moves, box, orientations, unknown words and moves that "
                  "cannot be checked");
  info.add_option("--json", arguments.json_file, "Write the result as JSON; - for standard output")->type_name("FILE");
  info.footer(
      "Example:\n"
      "  gougecheck path info finish.apt --json -\n\n"
      "Lengths in the output are in the unit of the file.\n\n" +
      std::string(kStatus));
  info.callback([&] { arguments.is_info = true; });

  CLI::App& convert =
      add_command(command, arguments, "convert", "Write the toolpath in another dialect, and report all losses");
  convert.add_option("-o,--output", arguments.output, "Output file; - for standard output")
      ->type_name("FILE")
      ->required();
  convert
      .add_option("--to", arguments.to,
                  "Dialect to write (default: a copy of the file, byte for byte): " + writable_dialect_names())
      ->type_name(kWritableDialect)
      ->check(why_not_writable);
  convert.footer(
      "Example:\n"
      "  gougecheck path convert finish.cls -o finish.apt --to apt-creo\n\n"
      "Motions, tools, feeds, CUTCOM, stops of the spindle and names of operations are written. "
      "Speeds, coolant and comments are not. Positions are written in part coordinates. mastercam-nci can be read but "
      "not written.\n\n" +
      std::string(kStatus));
  convert.callback([&] { arguments.is_convert = true; });

  CLI::App& plot =
      add_command(command, arguments, "plot", "Draw the toolpath in front view, top view and isometric view");
  plot.add_option("-o,--output", arguments.output, "Picture file, .png or .svg")->type_name("FILE")->required();
  plot.add_option("--part", arguments.parts, "Part that is drawn behind the path (STL; repeatable)")
      ->type_name("FILE")
      ->allow_extra_args(false);
  add_placement_options(plot, arguments.place, arguments.stl_units);
  plot.footer("Example:\n  gougecheck path plot finish.apt --part part.stl -o finish.png\n\n" + std::string(kStatus));

  CLI::App* laws = command.add_subcommand("laws", "Measure the difference between the laws of motion of a machine");
  add_path_laws_options(*laws, arguments.machine);
  CLI::App* joints = command.add_subcommand("joints", "Write the joint values of a machine for every record");
  add_path_joints_options(*joints, arguments.machine);
  for (CLI::App* one : {laws, joints}) {
    one->callback([&, one, joints] {
      arguments.is_machine = true;
      arguments.machine.is_joints = one == joints;
    });
  }
}

int run_path(const PathArguments& arguments, std::ostream& out, std::ostream& err) {
  if (arguments.is_machine) return run_path_machine(arguments.machine, out, err);
  Result<ToolpathReader> reader = ToolpathReader::make(arguments);
  if (!reader) return fail(err, {reader.error()});
  if (arguments.is_convert) reader->keep_origins();
  const bool is_plot = !arguments.is_info && !arguments.is_convert;
  const Result<bool> is_svg = is_plot ? is_svg_file(arguments.output) : false;
  if (!is_svg) return fail(err, {is_svg.error()});
  const Result<RigidTransform> place =
      arguments.place.empty() ? RigidTransform{} : understand_place("--place", arguments.place);
  if (!place) return fail(err, {place.error()});
  std::vector<InputOption> inputs = {{"the toolpath", arguments.path}};
  for (const std::string& part : arguments.parts) inputs.push_back({"--part", part});
  if (const auto status =
          refuse_outputs(inputs, asked_for({{"-o", arguments.output}, {"--json", arguments.json_file}}), err))
    return *status;
  const ReadOutcome outcome = reader->read(arguments.path);
  if (!outcome.toolpath) return fail(err, outcome.errors);
  if (arguments.is_info) return run_info(arguments, *outcome.toolpath, out, err);
  if (arguments.is_convert) return run_convert(arguments, *outcome.toolpath, reader->machine(), out, err);
  return run_plot(arguments, *place, *outcome.toolpath, *is_svg, err);
}

}  // namespace gouge

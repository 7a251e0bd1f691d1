#include "cli/commands/tool_command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <ostream>
#include <vector>

#include "cli/output/output_file.h"
#include "cli/terminal/print_diagnostics.h"
#include "lib/base/exit_code.h"
#include "lib/base/files.h"
#include "lib/base/number_text.h"
#include "lib/base/printable_text.h"
#include "postproc/image/font.h"
#include "postproc/image/render_drawing.h"
#include "toolmodels/bsp.h"
#include "toolmodels/compile_tool.h"
#include "toolmodels/draw_profile.h"
#include "toolmodels/import/read_any_tools.h"
#include "toolmodels/tool_library.h"

namespace gouge {

namespace {

using Tools = std::vector<const ToolAssembly*>;

Result<Tools> choose(const ToolLibrary& library, const std::string& wanted) {
  Tools chosen;
  if (wanted.empty()) {
    for (const ToolAssembly& tool : library.tools) chosen.push_back(&tool);
    return chosen;
  }
  const ToolAssembly* tool = library.called(wanted);
  if (tool == nullptr)
    return make_error("usage", "--tool '" + wanted + "': " + library.file +
                                   " has no tool of that number or name; see gougecheck tool list");
  if (const std::string two = library.two_tools_called(wanted); !two.empty())
    return make_error("usage", "--tool '" + wanted + "': in " + library.file + " it is " + two);
  return Tools{tool};
}

int draw(const Tools& tools, LengthUnit unit, const std::string& path, std::ostream& err) {
  const Result<bool> is_svg = is_svg_file(path);
  if (!is_svg) return fail(err, {is_svg.error()});
  const Result<Drawing> drawing = tools.size() == 1 ? draw_profile(*tools.front(), unit) : draw_sheet(tools, unit);
  if (!drawing) return fail(err, {drawing.error()});
  const Result<std::string> bytes = *is_svg ? Result<std::string>(render_svg(*drawing)) : render_png(*drawing);
  if (!bytes) return fail(err, {bytes.error()});
  std::vector<std::string> names;
  for (const ToolAssembly* tool : tools) names.push_back(tool->name);
  if (!*is_svg) print(err, find_missing_letters(names));
  const Outcome written = write_file(path, *bytes);
  if (written) return kExitClean;
  return fail(err, {written.error()}, kExitInternal);
}

void add_library_option(CLI::App& command, ToolArguments& arguments, ToolAction action) {
  command
      .add_option("--tools", arguments.tools_file,
                  "Tool library: JSON, or one of Fusion, FreeCAD, NX, CAMotics or LinuxCNC")
      ->type_name("FILE")
      ->required();
  add_input_limit(command, arguments.input);
  command.callback([&arguments, action] { arguments.action = action; });
}

void add_tool_option(CLI::App& command, ToolArguments& arguments) {
  command.add_option("--tool", arguments.tool, "Number or name of the tool (default: all tools)")->type_name("NAME");
}

constexpr const char* kExitText =
    "\nExit status: 0 done, 2 wrong command line, 3 library unreadable or invalid, 5 output unwritable.";

}  // namespace

void add_tool_options(CLI::App& command, ToolArguments& arguments) {
  command.require_subcommand(1);
  command.footer("Example:\n  gougecheck tool draw --tools shop.json --tool 3 -o t3.png");
  CLI::App* list = command.add_subcommand("list", "List the tools of a library");
  add_library_option(*list, arguments, ToolAction::list);
  list->footer(std::string("Example:\n  gougecheck tool list --tools shop.json\n") + kExitText);
  CLI::App* show = command.add_subcommand("show", "Show all dimensions of a tool and its contour");
  add_library_option(*show, arguments, ToolAction::show);
  add_tool_option(*show, arguments);
  show->footer(std::string("Example:\n  gougecheck tool show --tools shop.json --tool 3\n") + kExitText);
  CLI::App* picture = command.add_subcommand(
      "draw",
      "Draw a tool: profile, bodies, dimensions, Voronoi regions and correction directions. Without "
      "--tool, draw a sheet of the whole library");
  add_library_option(*picture, arguments, ToolAction::draw);
  add_tool_option(*picture, arguments);
  picture->add_option("-o,--output", arguments.output, "Picture file, .png or .svg")->type_name("FILE")->required();
  picture->footer(std::string("Example:\n  gougecheck tool draw --tools shop.json --tool 3 -o t3.svg\n"
                              "  gougecheck tool draw --tools shop.json -o library.png\n") +
                  kExitText);
  CLI::App* import =
      command.add_subcommand("import", "Convert a tool library of another program to the format of gougecheck");
  add_tool_import_options(*import, arguments.import, arguments.output);
  import->callback([&arguments] { arguments.action = ToolAction::import;
});
}  // namespace gouge

int run_tool(const ToolArguments& arguments, std::ostream& out, std::ostream& err) {
  if (arguments.action == ToolAction::import) return run_tool_import(arguments.import, arguments.output, out, err);
  if (arguments.action == ToolAction::draw) {
    const Result<bool> is_svg = is_svg_file(arguments.output);
    if (!is_svg) return fail(err, {is_svg.error()});
    if (const auto status =
            refuse_outputs({{"the tool library", arguments.tools_file}}, {{"-o", arguments.output}}, err))
      return *status;
  }
  const Result<ReadTools> read = read_tools_file(arguments.tools_file, arguments.input.max_bytes);
  if (!read) return fail(err, {read.error()});
  const ToolLibrary* const library = &read->library;
  print(err, library->notes);
  const Result<Tools> tools = choose(*library, arguments.tool);
  if (!tools) return fail(err, {tools.error()});
  switch (arguments.action) {
    case ToolAction::list:
      out << tool_list_text(*library);
      break;
    case ToolAction::show:
      for (const ToolAssembly* tool : *tools) out << tool_text(*tool, library->unit);
      break;
    case ToolAction::draw:
      return draw(*tools, library->unit, arguments.output, err);
    case ToolAction::import:
      break;
  }
  return kExitClean;
}

namespace {

std::string in_unit(double value_mm, LengthUnit unit) {
  return exact_text(std::round(value_mm / mm_per(unit) * 1e6) / 1e6);
}

const char* unit_word(LengthUnit unit) { return unit == LengthUnit::inch ? "inches" : "mm"; }

double widest(const std::vector<ToolSegment>& segments) {
  double diameter = 0;
  for (const ToolSegment& s : segments) diameter = std::max({diameter, s.lower_diameter_mm, s.upper_diameter_mm});
  return diameter;
}

double total(const std::vector<ToolSegment>& segments) {
  double length = 0;
  for (const ToolSegment& s : segments) length += s.length_mm;
  return length;
}

std::string segments_text(const ToolAssembly& tool, LengthUnit unit) {
  std::string text;
  for (const PositionedSegment& placed : position_segments(tool)) {
    const ToolSegment& s = placed.segment;
    text += "  " + padded(placed.name, 9) + " z " + in_unit(placed.z_mm, unit) + " to " +
            in_unit(placed.z_mm + s.length_mm, unit) + ", diameter " + in_unit(s.lower_diameter_mm, unit);
    if (std::abs(s.upper_diameter_mm - s.lower_diameter_mm) > 0) text += " to " + in_unit(s.upper_diameter_mm, unit);
    const bool has_own_name = placed.name.rfind(body_name(placed.body), 0) != 0;
    text += (has_own_name ? std::string(", counts as ") + body_name(placed.body) : "") + "\n";
  }
  return text;
}

std::string lengths_text(const ToolAssembly& tool, LengthUnit unit) {
  std::string text;
  if (!tool.holder.empty() || !tool.extensions.empty())
    text += "  stick-out " + in_unit(stickout_mm(tool), unit) + ", tip to what holds the tool\n";
  if (tool.gauge_length_mm > 0) text += "  gauge     " + in_unit(tool.gauge_length_mm, unit) + ", tip to gauge line\n";
  if (!tool.cuts) text += "  cuts      no: it removes no stock\n";
  return text;
}

std::string point_text(const Vec2& p, LengthUnit unit) {
  return "(" + in_unit(p.x(), unit) + ", " + in_unit(p.y(), unit) + ")";
}

std::string contour_text(const Profile& profile, LengthUnit unit) {
  std::string text = "  contour (r, z), from the tip:\n";
  for (const ProfileElement& e : profile.elements) {
    text += "    " + padded(body_name(e.body), 8) +
            padded(!e.is_arc      ? "line"
                   : e.is_concave ? "hollow"
                                  : "arc",
                   8) +
            point_text(e.a, unit) + " to " + point_text(e.b, unit);
    if (e.is_arc) text += ", radius " + in_unit(e.radius_mm, unit) + " about " + point_text(e.center, unit);
    text += "\n";
  }
  return text;
}

std::string tree_text(const CompiledTool& tool) {
  if (!tool.stretches.empty()) return "tree of " + std::to_string(tool.stretches.size()) + " stretches";
  return "BSP of " + std::to_string(tool.nodes.size()) + " nodes, depth " + std::to_string(bsp_depth(tool.nodes));
}

}  // namespace

std::string tool_list_text(const ToolLibrary& library) {
  const LengthUnit unit = library.unit;
  using Row = std::array<std::string, 6>;
  std::vector<Row> rows{{"tool", "name", "cutter", "flutes", "assembly", "holder"}};
  for (const ToolAssembly& t : library.tools) {
    const double height = height_mm(t);
    rows.push_back({t.number ? "T" + std::to_string(*t.number) : "-", t.name.empty() ? "-" : t.name,
                    describe_cutter(t.cutter, unit), in_unit(length_mm(t.cutter), unit), in_unit(height, unit),
                    t.holder.empty() ? "none" : "D " + in_unit(widest(t.holder), unit)});
  }
  std::array<std::size_t, 6> widths{};
  for (const Row& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], display_width(printable(row[i])));
  std::string text;
  for (const Row& row : rows) {
    for (std::size_t i = 0; i + 1 < row.size(); ++i) text += padded(row[i], widths[i] + 2);
    text += printable(row.back()) + "\n";
  }
  text += std::to_string(library.tools.size()) + (library.tools.size() == 1 ? " tool" : " tools") + ", lengths in " +
          unit_word(unit) + "\n";
  for (const NamedHolder& holder : library.holders)
    text += "holder \"" + printable(holder.name) + "\": D " + in_unit(widest(holder.segments), unit) + ", length " +
            in_unit(total(holder.segments), unit) + "\n";
  return text;
}

std::string tool_text(const ToolAssembly& tool, LengthUnit unit) {
  const Result<Profile> profile = make_profile(tool);
  if (!profile) return to_text(profile.error()) + "\n";
  const CompiledTool compiled = compile_tool(label(tool), *profile);
  std::string text = printable(label(tool)) + ", lengths in " + unit_word(unit) + "\n";
  text +=
      "  cutter    z 0 to " + in_unit(length_mm(tool.cutter), unit) + ", " + describe_cutter(tool.cutter, unit) + "\n";
  text += segments_text(tool, unit);
  text += lengths_text(tool, unit);
  text += "  assembly  length " + in_unit(height_mm(tool), unit) + ", largest diameter " +
          in_unit(2 * compiled.r_max_mm, unit) + "\n";
  text += contour_text(*profile, unit);
  text +=
      "  compiled  " + std::to_string(compiled.elements.size()) + " boundary elements, " + tree_text(compiled) + "\n";
  return text;
}

}  // namespace gouge

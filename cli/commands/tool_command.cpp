#include "cli/commands/tool_command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <ostream>
#include <vector>

#include "cli/commands/tool_text.h"
#include "cli/output/output_file.h"
#include "cli/output/picture_file.h"
#include "cli/terminal/print_diagnostics.h"
#include "lib/base/exit_code.h"
#include "lib/base/files.h"
#include "postproc/image/font.h"
#include "postproc/image/render_drawing.h"
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
  command.add_option("--tools", arguments.tools_file, "Tool library (JSON)")->type_name("FILE")->required();
  add_input_limit(command, arguments.input);
  command.callback([&arguments, action] { arguments.action = action; });
}

void add_tool_option(CLI::App& command, ToolArguments& arguments) {
  command.add_option("--tool", arguments.tool, "Number or name; without it, every tool")->type_name("NAME");
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
  CLI::App* show = command.add_subcommand("show", "Show every dimension of a tool, and the contour it makes");
  add_library_option(*show, arguments, ToolAction::show);
  add_tool_option(*show, arguments);
  show->footer(std::string("Example:\n  gougecheck tool show --tools shop.json --tool 3\n") + kExitText);
  CLI::App* picture = command.add_subcommand("draw",
                                             "Draw a tool: profile, bodies, dimensions, Voronoi regions and correction "
                                             "directions. Without --tool, a sheet of the whole library");
  add_library_option(*picture, arguments, ToolAction::draw);
  add_tool_option(*picture, arguments);
  picture->add_option("-o,--output", arguments.output, "Picture to write: .png or .svg")->type_name("FILE")->required();
  picture->footer(std::string("Example:\n  gougecheck tool draw --tools shop.json --tool 3 -o t3.svg\n"
                              "  gougecheck tool draw --tools shop.json -o library.png\n") +
                  kExitText);
  CLI::App* import = command.add_subcommand("import", "Turn a tool library of another program into ours");
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
  const Result<std::string> bytes = read_file(arguments.tools_file, arguments.input.most_bytes);
  if (!bytes) return fail(err, {bytes.error()});
  const Result<ReadTools> read = read_any_tools(arguments.tools_file, *bytes, arguments.input.most_bytes);
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

}  // namespace gouge

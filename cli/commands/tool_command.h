#pragma once

#include <iosfwd>
#include <string>

#include "cli/commands/tool_import.h"
#include "lib/base/units.h"
#include "toolmodels/tool_library.h"

namespace CLI {
class App;
}

namespace gouge {

enum class ToolAction { list, show, draw, import };

struct ToolArguments {
  ToolAction action = ToolAction::list;
  InputLimit input;
  std::string tools_file;
  std::string tool;    ///< number, T and number, or name; empty: all tools
  std::string output;  ///< for draw: a .png or .svg file; for import: the library to write
  ToolImportArguments import{};
};

void add_tool_options(CLI::App& command, ToolArguments& arguments);

/// Runs `gougecheck tool list|show|draw|import`, which shows the content of a tool library of this project or of
/// another program. Returns the exit status.
[[nodiscard]] int run_tool(const ToolArguments& arguments, std::ostream& out, std::ostream& err);

/// Returns a heading and one line for each tool, with aligned columns, and lengths in the unit of the library.
[[nodiscard]] std::string tool_list_text(const ToolLibrary& library);

/// Returns all dimensions of a tool and its contour. Requires a tool that make_profile accepts.
[[nodiscard]] std::string tool_text(const ToolAssembly& tool, LengthUnit unit);

}  // namespace gouge

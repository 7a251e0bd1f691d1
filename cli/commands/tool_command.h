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
  std::string tool;    ///< number, T and number, or name; empty: all
  std::string output;  ///< draw: .png or .svg; import: the library to write
  ToolImportArguments import{};
};

void add_tool_options(CLI::App& command, ToolArguments& arguments);

/// Runs `gougecheck tool list|show|draw|import`, which shows the content of a tool library, or of one of another
/// program. Returns the exit status.
[[nodiscard]] int run_tool(const ToolArguments& arguments, std::ostream& out, std::ostream& err);

/// Returns one line a tool under a heading, columns aligned, lengths in the library's unit.
[[nodiscard]] std::string tool_list_text(const ToolLibrary& library);

/// Returns every dimension of a tool, and the contour it makes. Requires a tool that make_profile accepts.
[[nodiscard]] std::string tool_text(const ToolAssembly& tool, LengthUnit unit);

}  // namespace gouge

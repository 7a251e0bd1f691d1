#pragma once

#include <iosfwd>
#include <string>

namespace CLI {
class App;
}

namespace gouge {

enum class ToolAction { list, show, draw };

struct ToolArguments {
  ToolAction action = ToolAction::list;
  std::string tools_file;
  std::string tool;    ///< number, T and number, or name; empty: all
  std::string output;  ///< draw: .png or .svg
};

void add_tool_options(CLI::App& command, ToolArguments& arguments);

/// `gougecheck tool list|show|draw`: what is in a tool library. Returns the exit status.
[[nodiscard]] int run_tool(const ToolArguments& arguments, std::ostream& out, std::ostream& err);

}  // namespace gouge

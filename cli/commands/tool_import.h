#pragma once

#include <iosfwd>
#include <string>

#include "cli/options/reading_options.h"

namespace CLI {
class App;
}

namespace gouge {

struct ToolImportArguments {
  std::string file;
  InputLimit input;
  std::string format = "auto";  ///< auto, fusion, freecad or nx
  std::string holder;           ///< name of a holder in `tools_file`
  std::string tools_file;
  std::string unit;      ///< mm or inch; empty: the file states it
  std::string stickout;  ///< as typed; empty: the file states it
};

void add_tool_import_options(CLI::App& command, ToolImportArguments& arguments, std::string& output);

/// Runs `gougecheck tool import`, which writes `output` in our format. Imported tools and assumptions go to `out`,
/// warnings and errors to `err`. Tools with impossible dimensions are left out, and then the exit status is 3.
[[nodiscard]] int run_tool_import(const ToolImportArguments& arguments, const std::string& output, std::ostream& out,
                                  std::ostream& err);

}  // namespace gouge

#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "cli/commands/path_machine.h"
#include "cli/commands/program_reading.h"

namespace CLI {
class App;
}

namespace gouge {

struct PathArguments : ProgramReading {
  std::string path;
  std::string json_file;
  std::string output, to;          ///< for convert and plot
  std::vector<std::string> parts;  ///< for plot
  std::string place, stl_units;
  bool is_info = false, is_convert = false, is_machine = false;
  PathMachineArguments machine;  ///< for laws and joints
};

void add_path_options(CLI::App& command, PathArguments& arguments);

/// Runs `gougecheck path info`, `convert` and `plot`. Returns the exit status.
[[nodiscard]] int run_path(const PathArguments& arguments, std::ostream& out, std::ostream& err);

}  // namespace gouge

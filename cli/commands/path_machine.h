#pragma once

#include <iosfwd>
#include <string>

#include "cli/commands/program_reading.h"

namespace CLI {
class App;
}

namespace gouge {

/// Arguments of `gougecheck path laws` and `path joints`.
struct PathMachineArguments : ProgramReading {
  std::string path, csv_file, height = "100";
  bool is_joints = false;
};

void add_path_laws_options(CLI::App& command, PathMachineArguments& arguments);
void add_path_joints_options(CLI::App& command, PathMachineArguments& arguments);

/// Runs `gougecheck path laws`, which reports the difference between the laws of motion on a path. Or runs `gougecheck
/// path joints`, which lists the joints of every record. Returns the exit status.
[[nodiscard]] int run_path_machine(const PathMachineArguments& arguments, std::ostream& out, std::ostream& err);

}  // namespace gouge

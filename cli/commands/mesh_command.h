#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

#include "cli/options/reading_options.h"

namespace CLI {
class App;
}

namespace gouge {

struct MeshArguments {
  std::string file;
  InputLimit input;
  std::string stl_units = "mm";
  std::string weld;         ///< a length; empty: only vertices with identical coordinates are joined
  std::string repair_file;  ///< empty: no repair
  bool fills_holes = false;
  std::string json_file;  ///< "-": standard output, which then has nothing else
  std::string progress = "auto";
  std::uint32_t threads = 0;               ///< 0: as many as the machine has
  std::vector<std::string> lengths_in_mm;  ///< lengths typed without a unit (length_rule.h)
};

void add_mesh_options(CLI::App& command, MeshArguments& arguments);

/// Runs `gougecheck mesh`, which tests whether a mesh bounds a solid and repairs it on request. Returns the exit
/// status: 0 sound (with --repair: the written mesh is sound), 1 defects, 3 unreadable, 4 not wholly decided, 5 output
/// unwritable.
[[nodiscard]] int run_mesh(const MeshArguments& arguments, std::ostream& out, std::ostream& err);

}  // namespace gouge

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
  std::string weld;         ///< a length; empty: only identical coordinates are one vertex
  std::string repair_file;  ///< empty: no repair
  bool fills_holes = false;
  std::string json_file;  ///< "-" writes to standard output alone
  std::string progress = "auto";
  std::uint32_t threads = 0;               ///< 0: all
  std::vector<std::string> lengths_in_mm;  ///< typed without a unit (length_rule.h)
};

void add_mesh_options(CLI::App& command, MeshArguments& arguments);

/// Runs `gougecheck mesh`, which validates a part as a solid, and repairs it. Returns the exit status: 0 sound (with
/// --repair: the written mesh is sound), 1 defects, 3 unreadable, 4 not wholly decided, 5 output unwritable.
[[nodiscard]] int run_mesh(const MeshArguments& arguments, std::ostream& out, std::ostream& err);

}  // namespace gouge

#pragma once

#include <iosfwd>
#include <string>

namespace CLI {
class App;
}

namespace gouge {

struct PathArguments {
  std::string path;
  std::string json_file;
};

void add_path_options(CLI::App& command, PathArguments& arguments);

/// `gougecheck path info`: what is in a toolpath file. Returns the exit status.
[[nodiscard]] int run_path(const PathArguments& arguments, std::ostream& out, std::ostream& err);

}  // namespace gouge

#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "lib/path/toolpath.h"
#include "toolmodels/assembly.h"

namespace gouge {

/// Finds tools of a path that have one number and different definitions. A machine has one tool of each number, so one
/// of the definitions is wrong. The number 0 states no tool. It counts for no tool, as CAM systems write it by default.
///
/// Definitions differ if diameter, corner, angles, or two stated lengths differ. Two tools of the library differ if
/// their outlines or lengths do. Names alone state no difference: two names may be those of one tool.
class SharedNumbers {
 public:
  explicit SharedNumbers(const Toolpath& path);

  /// Takes the next tool, with the index `tool` in Toolpath::tools. `known`, its tool of the library, must live as long as
  /// this object; it is null if the path defines the tool. Returns the contradiction to a tool that was taken before; empty:
  /// there is none. A tool without a move that is checked is not taken.
  [[nodiscard]] std::string take(std::size_t tool, const ToolAssembly& assembly, const ToolAssembly* known);

 private:
  struct Taken {
    const PathTool* tool;
    ToolAssembly assembly;
    const ToolAssembly* known;
  };
  [[nodiscard]] bool is_other(const Taken& a, const Taken& b) const;
  [[nodiscard]] std::string describe(const Taken& taken) const;

  const Toolpath& path_;
  std::vector<bool> is_checked_;  // of each tool of the path: it has a move that is checked
  std::vector<Taken> taken_;
};

}  // namespace gouge

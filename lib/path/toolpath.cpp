#include "lib/path/toolpath.h"

#include <algorithm>
#include <array>

namespace gouge {

const char* kind_name(MoveKind kind) {
  static constexpr std::array<const char*, 4> kNames = {"feed", "rapid", "arc", "cycle"};
  return kNames[static_cast<std::size_t>(kind)];
}

bool needs_wide_tool(const Toolpath& path, std::size_t tool) {
  return std::any_of(path.moves.begin(), path.moves.end(),
                     [&](const Move& move) { return move.tool == tool && move.needs_wide_tool(); });
}

}  // namespace gouge

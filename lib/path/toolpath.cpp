#include "lib/path/toolpath.h"

#include <algorithm>
#include <array>
#include <mutex>
#include <set>
#include <utility>

namespace gouge {

const char* kind_name(MoveKind kind) {
  static constexpr std::array<const char*, 4> kNames = {"feed", "rapid", "arc", "cycle"};
  return kNames[static_cast<std::size_t>(kind)];
}

const char* lasting_text(std::string text) {
  static std::mutex mutex;
  static std::set<std::string> texts;
  const std::lock_guard lock(mutex);
  return texts.insert(std::move(text)).first->c_str();
}

std::optional<double> gauge_length_of_move(const Toolpath& path, std::size_t move,
                                           const std::optional<double>& stated_mm) {
  const std::size_t tool = path.moves[move].tool;
  if (tool < path.tools.size() && path.tools[tool].gauge_length_mm) return path.tools[tool].gauge_length_mm;
  return path.tools.size() < 2 ? stated_mm : std::nullopt;
}

std::vector<bool> used_tools(const Toolpath& path) {
  std::vector<bool> is_used(path.tools.size(), false);
  for (const Move& move : path.moves)
    if (move.tool != kNone) is_used[move.tool] = true;
  return is_used;
}

bool needs_wide_tool(const Toolpath& path, std::size_t tool) {
  return std::any_of(path.moves.begin(), path.moves.end(),
                     [&](const Move& move) { return move.tool == tool && move.needs_wide_tool(); });
}

}  // namespace gouge

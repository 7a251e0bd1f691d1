#include "toolmodels/tool_library.h"

#include <algorithm>

namespace gouge {

const ToolAssembly* ToolLibrary::with_number(int number) const {
  const auto found =
      std::find_if(tools.begin(), tools.end(), [&](const ToolAssembly& t) { return t.number == number; });
  return found == tools.end() ? nullptr : &*found;
}

const ToolAssembly* ToolLibrary::with_name(std::string_view name) const {
  const auto found =
      std::find_if(tools.begin(), tools.end(), [&](const ToolAssembly& t) { return t.name == name; });
  return found == tools.end() ? nullptr : &*found;
}

const std::vector<ToolSegment>* ToolLibrary::holder_called(std::string_view name) const {
  for (const NamedHolder& holder : holders) {
    if (holder.name == name) return &holder.segments;
  }
  const ToolAssembly* tool = with_name(name);
  return tool != nullptr && !tool->holder.empty() ? &tool->holder : nullptr;
}

}  // namespace gouge

#include "toolmodels/library.h"

#include <algorithm>

#include "lib/base/number_text.h"

namespace gouge {

const ToolAssembly* find_tool(const ToolLibrary& library, int number) {
  const auto found = std::find_if(library.tools.begin(), library.tools.end(),
                                  [&](const ToolAssembly& tool) { return tool.number == number; });
  return found == library.tools.end() ? nullptr : &*found;
}

const ToolAssembly* find_tool(const ToolLibrary& library, std::string_view name) {
  const auto found = std::find_if(library.tools.begin(), library.tools.end(),
                                  [&](const ToolAssembly& tool) { return tool.name == name; });
  return found == library.tools.end() ? nullptr : &*found;
}

Result<std::vector<ToolSegment>> find_holder(const ToolLibrary& library, std::string_view name) {
  for (const NamedHolder& holder : library.holders)
    if (holder.name == name) return holder.segments;
  const ToolAssembly* tool = find_tool(library, name);
  const std::string_view digits = name.starts_with('T') ? name.substr(1) : name;
  const std::optional<long long> number = parse_integer(digits);
  if (tool == nullptr && number && *number >= 0 && *number <= 999'999'999)
    tool = find_tool(library, static_cast<int>(*number));
  if (tool != nullptr && !tool->holder.empty()) return tool->holder;
  std::string known;
  for (const NamedHolder& holder : library.holders) known += (known.empty() ? "" : ", ") + holder.name;
  for (const ToolAssembly& t : library.tools)
    if (!t.holder.empty()) known += (known.empty() ? "" : ", ") + label(t);
  return make_error("library-unknown-holder",
                    tool != nullptr ? "tool " + label(*tool) + " has no holder to take"
                                    : "there is no holder \"" + std::string(name) + "\"; " +
                                          (known.empty() ? "the library has none" : "there are: " + known),
                    library.file);
}

}  // namespace gouge

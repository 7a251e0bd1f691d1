#include "toolmodels/tool_library.h"

#include <algorithm>

#include "lib/base/number_text.h"

namespace gouge {

std::optional<int> tool_number(std::string_view text) {
  constexpr long long kMost = 999'999'999;
  const auto number = parse_integer(text.substr(text.starts_with('T') || text.starts_with('t') ? 1 : 0));
  if (!number || *number < 0 || *number > kMost) return std::nullopt;
  return static_cast<int>(*number);
}

const ToolAssembly* ToolLibrary::with_number(int number) const {
  const auto found = std::ranges::find_if(tools, [&](const ToolAssembly& t) { return t.number == number; });
  return found == tools.end() ? nullptr : &*found;
}

const ToolAssembly* ToolLibrary::with_name(std::string_view name) const {
  const auto found = std::ranges::find_if(tools, [&](const ToolAssembly& t) { return t.name == name; });
  return found == tools.end() ? nullptr : &*found;
}

bool ToolLibrary::is_shared_number(int number) const {
  return std::ranges::find(shared_numbers, number) != shared_numbers.end();
}

bool ToolLibrary::is_shared_name(std::string_view name) const {
  return std::ranges::find(shared_names, name) != shared_names.end();
}

const ToolAssembly* ToolLibrary::called(std::string_view name) const {
  if (const ToolAssembly* tool = with_name(name)) return tool;
  const auto number = tool_number(name);
  return number ? with_number(*number) : nullptr;
}

std::string uncertainty_of_owner(const NamedHolder& holder) {
  return holder.uncertainty.empty() ? std::string() : "holder \"" + holder.name + "\": " + holder.uncertainty;
}

std::optional<NamedHolder> ToolLibrary::holder_called(std::string_view name) const {
  for (const NamedHolder& holder : holders) {
    if (holder.name == name) return holder;
  }
  const ToolAssembly* tool = with_name(name);
  if (tool == nullptr || tool->holder.empty()) return std::nullopt;
  return NamedHolder{tool->name, tool->holder, tool->uncertainty};
}

std::string ToolLibrary::holder_names() const {
  std::string names;
  const auto add = [&](const std::string& name) {
    if (!name.empty()) names += (names.empty() ? "" : ", ") + name;
  };
  for (const NamedHolder& holder : holders) add(holder.name);
  for (const ToolAssembly& tool : tools) {
    if (!tool.holder.empty()) add(tool.name);
  }
  return names.empty() ? "none" : names;
}

}  // namespace gouge

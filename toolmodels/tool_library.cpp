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

namespace {

// Returns the tool with the number that `name` states, if another tool has this name; else null.
const ToolAssembly* other_with_number(const ToolLibrary& library, std::string_view name) {
  const auto number = tool_number(name);
  const ToolAssembly* const by_number = number ? library.with_number(*number) : nullptr;
  const ToolAssembly* const by_name = library.with_name(name);
  return by_name == nullptr || by_name == by_number ? nullptr : by_number;
}

// Returns a text that means this tool alone: its name, or else its number. Empty: there is none.
std::string sure_name(const ToolLibrary& library, const ToolAssembly& tool) {
  const std::string number = tool.number ? std::to_string(*tool.number) : "";
  for (const std::string& text : {tool.name, number, number.empty() ? number : "T" + number})
    if (!text.empty() && library.called(text) == &tool && other_with_number(library, text) == nullptr) return text;
  return {};
}

std::string choice_text(const ToolLibrary& library, const ToolAssembly& tool) {
  const std::string name = sure_name(library, tool);
  return name.empty() ? "another name in the library" : "'" + name + "'";
}

}  // namespace

std::string ToolLibrary::two_tools_called(std::string_view name) const {
  const ToolAssembly* const by_number = other_with_number(*this, name);
  if (by_number == nullptr) return {};
  const ToolAssembly& by_name = *with_name(name);
  return "the number of " + label(*by_number) + " and the name of " + label(by_name) + "; expected " +
         choice_text(*this, *by_number) + " for the first, or " + choice_text(*this, by_name) + " for the second";
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

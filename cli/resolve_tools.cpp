#include "cli/resolve_tools.h"

#include <algorithm>
#include <map>

#include "lib/base/number_text.h"
#include "toolmodels/from_path.h"

namespace gouge {
namespace {

std::string name_of(const PathTool& tool) {
  if (tool.number) return "T" + std::to_string(*tool.number);
  return tool.name.empty() ? "the tool" : "tool \"" + tool.name + "\"";
}

std::string names_in(const ToolLibrary& library) {
  std::string names;
  for (const ToolAssembly& tool : library.tools) names += (names.empty() ? "" : ", ") + label(tool);
  return names.empty() ? "none" : names;
}

class Resolver {
 public:
  Resolver(const Toolpath& path, const ToolLibrary* library, std::string holder)
      : path_(path), library_(library), holder_(std::move(holder)) {}

  std::optional<Diagnostic> take_names(const std::vector<std::string>& tool_names) {
    for (const std::string& text : tool_names) {
      const std::size_t equals = text.find('=');
      const auto number = parse_integer(text.substr(0, equals));
      if (!number || equals == std::string::npos) return usage("--tool '" + text + "': expected N=NAME");
      if (library_ == nullptr) return usage("--tool '" + text + "' needs a library: give --tools LIB.json");
      const ToolAssembly* tool = library_->with_name(text.substr(equals + 1));
      if (tool == nullptr) {
        return usage("--tool '" + text + "': the library has no tool of that name; it has " + names_in(*library_));
      }
      named_[static_cast<int>(*number)] = tool;
    }
    if (holder_.empty()) return std::nullopt;
    if (library_ == nullptr) return usage("--holder '" + holder_ + "' needs a library: give --tools LIB.json");
    segments_ = library_->holder_called(holder_);
    if (segments_ == nullptr) return usage("--holder '" + holder_ + "': the library has neither a holder nor a tool with a holder of that name");
    return std::nullopt;
  }

  Result<ResolvedTools> run() {
    ResolvedTools result;
    for (const PathTool& tool : path_.tools) {
      ToolFacts facts;
      facts.name = tool.number ? "T" + std::to_string(*tool.number) : tool.name;
      std::optional<ToolAssembly> assembly = find(tool, facts, result.notes);
      if (assembly) {
        if (assembly->holder.empty() && segments_ != nullptr) assembly->holder = *segments_;
        const Result<Profile> profile = make_profile(*assembly);
        if (!profile) return at(profile.error(), tool);
        facts.description = describe(*assembly);
        if (assembly->holder.empty()) {
          result.notes.push_back(make_note("tool-no-holder", name_of(tool) + " has no holder: only what is defined is checked", path_.file, tool.line));
        }
      } else {
        result.notes.push_back(make_warning("tool-undefined",
            name_of(tool) + " is defined neither in a library nor by CUTTER or TLDATA: its moves are not checked; "
            "give --tools LIB.json with its number", path_.file, tool.line));
      }
      result.assemblies.push_back(std::move(assembly));
      result.facts.push_back(std::move(facts));
    }
    return result;
  }

 private:
  static Diagnostic usage(const std::string& message) { return make_error("usage", message); }

  [[nodiscard]] Diagnostic at(Diagnostic error, const PathTool& tool) const {
    if (error.file.empty()) {
      error.file = path_.file;
      error.line = tool.line;
    }
    return error;
  }

  std::optional<ToolAssembly> find(const PathTool& tool, ToolFacts& facts, Diagnostics& notes) const {
    const ToolAssembly* known = in_library(tool);
    if (known != nullptr) {
      facts.defined_in = library_->file;
      return *known;
    }
    if (!tool.cutter) return std::nullopt;
    facts.defined_in = path_.file + ":" + std::to_string(tool.line);
    return from_statement(tool, notes);
  }

  [[nodiscard]] const ToolAssembly* in_library(const PathTool& tool) const {
    if (library_ == nullptr) return nullptr;
    const auto named = tool.number ? named_.find(*tool.number) : named_.end();
    if (named != named_.end()) return named->second;
    const ToolAssembly* by_number = tool.number ? library_->with_number(*tool.number) : nullptr;
    if (by_number != nullptr) return by_number;
    return tool.name.empty() ? nullptr : library_->with_name(tool.name);
  }

  ToolAssembly from_statement(const PathTool& tool, Diagnostics& notes) const {
    const CutterStatement& c = *tool.cutter;
    const Result<ToolFromPath> made = make_tool_from_path(
        tool.number, tool.name,
        {c.d_mm, c.r_mm, c.e_mm, c.f_mm, c.alpha_deg, c.beta_deg, c.h_mm, c.given, tool.flute_length_mm}, {});
    if (!made) {  // the numbers as they are, so that building the tool says what is wrong with them
      const AptCutter apt{c.d_mm, c.r_mm, c.e_mm, c.f_mm, c.alpha_deg, c.beta_deg, c.h_mm};
      return {tool.number, tool.name, apt, {}, {}};
    }
    for (const Diagnostic& note : made->notes) notes.push_back(at(note, tool));
    return made->tool;
  }

  static std::string describe(const ToolAssembly& tool) {
    std::string text = shape_name(tool.cutter);
    if (!tool.name.empty()) text = tool.name + " (" + text + ")";
    double widest = 0;
    for (const ToolSegment& s : tool.holder) widest = std::max({widest, s.lower_diameter_mm, s.upper_diameter_mm});
    if (widest > 0) text += ", holder to D" + exact_text(widest) + " mm";
    return text;
  }

  const Toolpath& path_;
  const ToolLibrary* library_;
  std::string holder_;
  std::map<int, const ToolAssembly*> named_;
  const std::vector<ToolSegment>* segments_ = nullptr;
};

}  // namespace

Result<ResolvedTools> resolve_tools(const Toolpath& path, const ToolLibrary* library,
                                    const std::vector<std::string>& tool_names, const std::string& holder) {
  Resolver resolver(path, library, holder);
  if (const auto error = resolver.take_names(tool_names)) return *error;
  return resolver.run();
}

}  // namespace gouge

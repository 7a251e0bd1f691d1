#include "cli/tools/resolve_tools.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

#include "cli/tools/shared_numbers.h"
#include "lib/base/number_text.h"
#include "postproc/cldata/language/dialect.h"
#include "postproc/report/report_text.h"
#include "toolmodels/draw_profile.h"
#include "toolmodels/from_path.h"

namespace gouge {
namespace {

std::string names_in(const ToolLibrary& library) {
  std::vector<std::string> names;
  for (const ToolAssembly& tool : library.tools) names.push_back(label(tool));
  return names.empty() ? "none" : listed(names);
}

std::string describe(const ToolAssembly& tool, LengthUnit unit) {
  std::string text = describe_cutter(tool.cutter, unit);
  if (!tool.name.empty()) text = tool.name + ": " + text;
  text += ", stick-out " + length_text(stickout_mm(tool), unit);
  double widest = 0;
  for (const ToolSegment& s : tool.holder) widest = std::max({widest, s.lower_diameter_mm, s.upper_diameter_mm});
  if (widest > 0) text += ", holder to D " + length_text(widest, unit);
  return text;
}

// Returns "T7", or the name of a tool without a number, which may be empty.
std::string short_name(const PathTool& tool) { return tool.number ? "T" + std::to_string(*tool.number) : tool.name; }

Diagnostic usage(const std::string& message) { return make_error("usage", message); }

class Resolver {
 public:
  Resolver(const Toolpath& path, const ToolLibrary* library, ToolUse use, GaugeLength length)
      : path_(path), library_(library), use_(use), length_(length), numbers_(path) {}

  std::optional<Diagnostic> take_name(const std::string& text) {
    const std::size_t equals = text.find('=');
    const bool is_for_unnamed = equals == std::string::npos;
    if (equals == 0) {
      return usage(
          "--tool '" + text +
          "': expected N=NAME, N a tool of the toolpath by number or name and NAME one of the library, or NAME "
          "alone");
    }
    if (library_ == nullptr) return usage("--tool '" + text + "' needs a library: give --tools LIB.json");
    const std::string name = is_for_unnamed ? text : text.substr(equals + 1);
    const ToolAssembly* tool = library_->called(name);
    if (tool == nullptr) {
      return usage("--tool '" + text + "': the library has no tool of that name or number; it has " +
                   names_in(*library_));
    }
    if (const std::string two = library_->two_tools_called(name); !two.empty())
      return usage("--tool '" + text + "': in " + library_->file + ", '" + name + "' is " + two);
    if (is_for_unnamed) {
      unnamed_ = {text, tool};
    } else if (const std::string key = key_of(text.substr(0, equals)); !named_.emplace(key, tool).second) {
      return usage("--tool '" + text + "': tool " + key + " of the toolpath has one already; expected each tool once");
    }
    return std::nullopt;
  }

  void take_every(const ToolAssembly& tool) { every_ = &tool; }

  std::optional<Diagnostic> take_holder(const std::string& name) {
    if (library_ == nullptr) return usage("--holder '" + name + "' needs a library: give --tools LIB.json");
    const std::optional<NamedHolder> holder = library_->holder_called(name);
    if (!holder) {
      return usage("--holder '" + name +
                   "': the library has neither a holder nor a tool with a holder of that name; it has " +
                   library_->holder_names());
    }
    holder_ = *holder;
    return std::nullopt;
  }

  Result<ResolvedTools> run() {
    const std::vector<bool> is_used = used_tools(path_);
    for (std::size_t i = 0; i < path_.tools.size(); ++i) {
      const PathTool& tool = path_.tools[i];
      ToolFacts facts;
      facts.name = short_name(tool);
      contradiction_.clear();
      shared_.clear();
      is_of_path_ = false;
      uncertainty_.clear();
      doubt_.clear();
      basis_ = Basis::stated;
      if (const auto error = resolve(tool, facts)) return *error;
      if (const auto& assembly = result_.assemblies.back()) shared_ = numbers_.take(i, *assembly, in_library(tool));
      if (is_used[i]) assume(tool, facts, result_.assemblies.back().has_value());
      result_.facts.push_back(std::move(facts));
    }
    assume_names(is_used);
    return std::move(result_);
  }

 private:
  void assume(const PathTool& tool, const ToolFacts& facts, bool is_defined) {
    const std::string object = facts.name.empty() ? "unnamed" : facts.name;
    Assumption of_tool{.subject = Subject::tool, .object = object, .basis = basis_, .value = facts.description};
    of_tool.code = "tool-differs";
    of_tool.file = path_.file;
    of_tool.line = tool.line;
    of_tool.evidence = facts.defined_in;
    of_tool.remedy = "correct the library or --tool, or state that it is right with --assume tool=" + object;
    if (!is_defined) {
      of_tool.basis = Basis::unknown;
      of_tool.code = "tool-undefined";
      of_tool.value = "not defined";
      of_tool.evidence = name_of(tool) +
                         " is defined neither in a library nor by CUTTER or TLDATA: its moves are not "
                         "checked";
      of_tool.remedy = "give --tools LIB.json with its number";
    } else if (!contradiction_.empty()) {
      of_tool.basis = Basis::contradicted;
      of_tool.evidence = contradiction_;
      if (is_of_path_) {
        of_tool.code = "cutter-contradiction";
        of_tool.remedy =
            "correct the cutter in the toolpath, give the tool with --tools, or state that it is right with "
            "--assume tool=" +
            object;
      }
    } else if (!shared_.empty()) {
      of_tool.basis = Basis::contradicted;
      of_tool.code = "tool-number-shared";
      of_tool.evidence = shared_;
      of_tool.remedy =
          "give each tool its own number, or state that all of them are right with --assume tool=" + object;
    } else if (!uncertainty_.empty()) {
      of_tool.code = basis_ == Basis::by_default ? "cutter-length" : "tool-doubtful";
      of_tool.evidence = uncertainty_;
    } else if (!doubt_.empty()) {
      of_tool.basis = Basis::by_default;
      of_tool.evidence = doubt_;
    }
    if (is_defined && of_tool.basis < Basis::contradicted) note_register(tool, of_tool);
    result_.assumptions.push_back(std::move(of_tool));
    if (is_defined) assume_holder(tool, facts, object);
  }

  // Lists a register of the length that is not the tool's own number. Some shops have registers of their own.
  static void note_register(const PathTool& tool, Assumption& of_tool) {
    if (!tool.other_register) return;
    const std::string evidence = name_of(tool) + " takes its length from register " +
                                 std::to_string(*tool.other_register) + ", which may hold that of another tool";
    const bool has_assumed_length = of_tool.basis == Basis::by_default;
    of_tool.evidence = has_assumed_length ? of_tool.evidence + "; " + evidence : evidence;
    of_tool.basis = Basis::by_default;
    of_tool.code = "tool-register";
    of_tool.remedy = "state that the register holds the length of this tool with --assume tool=" + of_tool.object;
  }

  void assume_holder(const PathTool& tool, const ToolFacts& facts, const std::string& object) {
    Assumption of_holder{.subject = Subject::holder, .object = object, .basis = Basis::stated};
    of_holder.code = "tool-no-holder";
    of_holder.file = path_.file;
    of_holder.line = tool.line;
    of_holder.value = facts.has_holder ? "given" : "none";
    of_holder.evidence = facts.has_holder ? library_->file : name_of(tool) + " has no holder, so none is checked";
    of_holder.remedy = "give one in the library or with --holder, or state with --assume holder that none is needed";
    if (!facts.has_holder) of_holder.basis = Basis::by_default;
    result_.assumptions.push_back(std::move(of_holder));
  }

  // Adds a contradicted assumption if no move has a tool that --tool names, or if no move is without a tool and one is
  // given for such moves. The tool that the user means would come from elsewhere.
  void assume_names(const std::vector<bool>& is_used) {
    std::vector<std::string> loaded;
    bool is_any_named = named_.empty(), is_any_unnamed = unnamed_.second == nullptr;
    for (std::size_t i = 0; i < path_.tools.size(); ++i) {
      if (!is_used[i]) continue;
      const PathTool& tool = path_.tools[i];
      is_any_named = is_any_named || named_for(tool) != nullptr;
      is_any_unnamed = is_any_unnamed || (!tool.number && tool.name == unnamed_.first);
      loaded.push_back(short_name(tool));
    }
    if (loaded.empty()) return;
    const std::string of_path = ", and the toolpath loads " + listed(loaded, " and ");
    if (!is_any_named) {
      std::vector<std::string> named;
      for (const auto& entry : named_) named.push_back(entry.first);
      assume_unused(listed(named), "--tool names " + listed(named, " and ") + of_path,
                    "name a tool that it loads, or leave --tool out");
    }
    if (!is_any_unnamed)
      assume_unused(unnamed_.first, "--tool " + unnamed_.first + " is for moves that name no tool" + of_path,
                    "write --tool " + loaded.front() + "=" + unnamed_.first + ", or leave --tool out");
  }

  void assume_unused(const std::string& object, const std::string& evidence, const std::string& remedy) {
    Assumption fact{.subject = Subject::tool, .object = object, .basis = Basis::contradicted, .value = "unused"};
    fact.code = "tool-not-loaded";
    fact.file = path_.file;
    fact.evidence = evidence;
    fact.remedy = remedy;
    result_.assumptions.push_back(std::move(fact));
  }

  [[nodiscard]] Diagnostic at(Diagnostic diagnostic, const PathTool& tool) const {
    if (diagnostic.file.empty()) {
      diagnostic.file = path_.file;
      diagnostic.line = tool.line;
    }
    return diagnostic;
  }

  std::optional<Diagnostic> resolve(const PathTool& tool, ToolFacts& facts) {
    std::optional<ToolAssembly> assembly;
    if (const ToolAssembly* known = in_library(tool)) {
      facts.defined_in = library_->file;
      basis_ = is_named(tool) ? Basis::stated : Basis::derived;
      assembly = *known;
      const bool has_own_holder = !assembly->holder.empty();
      if (!has_own_holder) assembly->holder = holder_.segments;
      ToolDifference difference = compare_tools(tool, *known, path_, {*library_, holder_.segments, use_, length_});
      if (!difference.contradiction.empty()) contradict(difference.contradiction);
      doubt_ = difference.doubt;
      std::ranges::move(difference.warnings, std::back_inserter(result_.notes));
      mark_library_uncertain(tool, *known);
      if (!has_own_holder) mark_holder_uncertain(tool, *known);
    } else if (tool.cutter) {
      note_not_in_library(tool);
      facts.defined_in = path_.file + ":" + std::to_string(tool.line);
      const Result<ToolFromPath> made = make_tool_from_path(tool, holder_.segments);
      if (!made) return at(made.error(), tool);
      for (const Diagnostic& note : made->notes) {
        if (note.code == "cutter-length") {
          basis_ = Basis::by_default;
          uncertainty_ = note.message;
        }
        if (note.code != "cutter-contradiction") {
          result_.notes.push_back(at(note, tool));
          continue;
        }
        is_of_path_ = true;
        contradict(note.message);  // an open fact, which is a warning by itself
      }
      assembly = made->tool;
      mark_holder_uncertain(tool, ToolAssembly{});
    }
    report(tool, assembly, facts);
    result_.assemblies.push_back(std::move(assembly));
    return std::nullopt;
  }

  void note_not_in_library(const PathTool& tool) {
    if (library_ == nullptr) return;
    result_.notes.push_back(make_warning("tool-not-in-library",
                                         name_of(tool) + " is not in the library, which has " + names_in(*library_) +
                                             ": the toolpath's own definition is checked" +
                                             (holder_.segments.empty() ? ", without shank and holder" : ""),
                                         path_.file, tool.line));
  }

  // Marks the tool as unknown if the library left out a part of it, or has several tools with its number or name.
  void mark_library_uncertain(const PathTool& tool, const ToolAssembly& known) {
    const bool is_found_by_number = !is_named(tool) && tool.number && known.number == tool.number;
    const bool is_found_by_name = !is_named(tool) && !is_found_by_number && known.name == tool.name;
    if (is_found_by_number && library_->is_shared_number(*tool.number))
      uncertainty_ = library_->file + " has several tools of number " + std::to_string(*tool.number);
    else if (is_found_by_name && library_->is_shared_name(tool.name))
      uncertainty_ = library_->file + " has several tools with the name " + tool.name;
    else if (!known.uncertainty.empty())
      uncertainty_ = name_of(tool) + ": " + known.uncertainty;
    if (!uncertainty_.empty()) basis_ = Basis::unknown;
  }

  // Marks a tool without a holder of its own as unknown if the one of --holder is uncertain, or none takes the place of
  // a holder that the library names.
  void mark_holder_uncertain(const PathTool& tool, const ToolAssembly& known) {
    const std::string why = !holder_.uncertainty.empty() ? uncertainty_of_owner(holder_)
                            : holder_.segments.empty()   ? known.missing_holder
                                                         : std::string();
    if (why.empty()) return;
    if (basis_ != Basis::unknown) uncertainty_ = name_of(tool) + ": " + why;
    basis_ = Basis::unknown;
  }

  void contradict(const std::string& what) { contradiction_ += (contradiction_.empty() ? "" : "; ") + what; }

  void report(const PathTool& tool, const std::optional<ToolAssembly>& assembly, ToolFacts& facts) {
    if (!assembly) return;
    facts.description = describe(*assembly, path_.unit);
    facts.has_holder = !assembly->holder.empty();
    if (facts.has_holder) return;
    const std::string message =
        name_of(tool) + " has no holder, so none is checked; give one in the library or with --holder";
    result_.notes.push_back(make_note("tool-no-holder", message, path_.file, tool.line));
  }

  [[nodiscard]] bool is_named(const PathTool& tool) const {
    if (every_ != nullptr) return true;
    if (named_for(tool) != nullptr) return true;
    return !tool.number && !tool.name.empty() && tool.name == unnamed_.first;
  }

  /// Returns how --tool names a tool of the path: "T7" for any form of a number.
  [[nodiscard]] static std::string key_of(const std::string& text) {
    const std::optional<int> number = tool_number(text);
    return number ? "T" + std::to_string(*number) : text;
  }

  /// Returns the tool that --tool gives for a tool of the path, by its number or else by its name; null: none.
  [[nodiscard]] const ToolAssembly* named_for(const PathTool& tool) const {
    const auto find = [&](const std::string& key) {
      const auto found = named_.find(key);
      return found == named_.end() ? nullptr : found->second;
    };
    const ToolAssembly* const by_number = tool.number ? find(short_name(tool)) : nullptr;
    // A number that --tool names is meant as a number if the tool has one.
    const bool may_have_name = !tool.name.empty() && !(tool.number && tool_number(tool.name));
    return by_number == nullptr && may_have_name ? find(key_of(tool.name)) : by_number;
  }

  [[nodiscard]] const ToolAssembly* in_library(const PathTool& tool) const {
    if (library_ == nullptr) return nullptr;
    if (every_ != nullptr) return every_;
    if (const ToolAssembly* const named = named_for(tool)) return named;
    const ToolAssembly* by_number = tool.number ? library_->with_number(*tool.number) : nullptr;
    if (by_number != nullptr) return by_number;
    if (!tool.number && !tool.name.empty() && tool.name == unnamed_.first) return unnamed_.second;
    return tool.name.empty() ? nullptr : library_->with_name(tool.name);
  }

  const Toolpath& path_;
  const ToolLibrary* library_;
  ToolUse use_;
  GaugeLength length_;
  std::map<std::string, const ToolAssembly*> named_;     // by key_of
  std::pair<std::string, const ToolAssembly*> unnamed_;  // the name of the tool for moves without one, and that tool
  const ToolAssembly* every_ = nullptr;  // the tool in place of all tools of the path; null: each has its own
  NamedHolder holder_;                   // of tools without one
  Basis basis_ = Basis::stated;          // of the tool being resolved, like the next two members
  std::string contradiction_;            // contradictions about it
  std::string shared_;                   // another definition of its number
  bool is_of_path_ = false;              // they are within the toolpath, not between it and the library
  std::string uncertainty_;              // unknown facts about it
  std::string doubt_;                    // a default that its lengths rest on
  SharedNumbers numbers_;
  ResolvedTools result_;
};

}  // namespace

Result<ResolvedTools> resolve_tools(const Toolpath& path, const ToolLibrary* library,
                                    const std::vector<std::string>& tool_names, const std::string& holder, ToolUse use,
                                    GaugeLength length) {
  Resolver resolver(path, library, use, length);
  for (const std::string& name : tool_names) {
    if (const auto error = resolver.take_name(name)) return *error;
  }
  if (!holder.empty()) {
    if (const auto error = resolver.take_holder(holder)) return *error;
  }
  return resolver.run();
}

Diagnostic describe_missing_tools(const Toolpath& path, const std::string& library) {
  const std::size_t line = path.tools.empty() ? std::size_t{path.moves.front().line} : path.tools.front().line;
  std::vector<std::string> names;
  for (std::size_t tool = 0; tool < path.tools.size(); ++tool) names.push_back(tool_label(path, tool));
  const bool is_program = path.dialect == gcode_dialect().id;
  return make_error("no-tool",
                    "no tool of the toolpath is defined" + (names.empty() ? "" : " (" + listed(names) + ")") +
                        ", so nothing can be checked; expected " +
                        (is_program ? "" : "CUTTER or TLDATA in the file, or ") +
                        (library.empty() ? "a library that has the tool: --tools LIB.json"
                                         : "the tool in " + library + ", or --tool NUMBER=NAME") +
                        ", with --tool NAME where the file names none",
                    path.file, line);
}

Result<ResolvedTools> resolve_given(const Toolpath& path, const ToolAssembly& tool, ToolUse use, GaugeLength length) {
  ToolLibrary library;
  library.file = "memory";
  library.tools = {tool};
  Resolver resolver(path, &library, use, length);
  resolver.take_every(library.tools.front());
  return resolver.run();
}

}  // namespace gouge

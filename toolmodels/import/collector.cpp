#include "toolmodels/import/collector.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include "lib/base/files.h"
#include "lib/base/letters.h"

namespace gouge {

Collector::Collector(std::string file, const ImportOptions& options) : options_(options) {
  made_.library.file = std::move(file);
}

std::string tool_label(const std::optional<int>& number, const std::string& name) {
  ToolAssembly tool;
  tool.number = number;
  tool.name = name;
  return "tool " + label(tool);
}

std::optional<int> tool_number(long long number) {
  if (number < 0 || number > 999'999'999) return std::nullopt;
  return static_cast<int>(number);
}

void Collector::report(const std::string& who, const Diagnostic& diagnostic, std::size_t line) {
  Diagnostic reported = diagnostic;
  if (!reported.message.starts_with(who + ": ")) reported.message = who + ": " + reported.message;
  if (reported.file.empty()) {
    reported.file = file();
    reported.line = line;
  }
  made_.notes.push_back(std::move(reported));
}

void Collector::leave_out(const std::string& who, const std::string& shape, std::size_t line) {
  report(who, make_warning("import-shape", "not imported: shape " + shape), line);
}

void Collector::count(const std::optional<int>& number, const std::string& name) {
  if (number) ++tools_of_number_[*number];
  if (!name.empty()) ++tools_of_name_[name];
}

void Collector::assign_number(ToolAssembly& tool, std::size_t line) {
  if (!tool.number || numbers_.insert(*tool.number).second) return;
  const std::string who = tool_label(tool.number, tool.name);
  const int number = *tool.number;
  tool.number.reset();
  if (tool.name.empty()) tool.name = "tool at position " + std::to_string(made_.library.tools.size() + 1);
  report(who,
         make_warning("import-number", "number " + std::to_string(number) +
                                           " is already taken; this tool is imported without number, as \"" +
                                           tool.name + "\""),
         line);
}

void Collector::report_of(const CatalogueTool& tool, const std::string& who, Diagnostic diagnostic) {
  if (!tool.file.empty()) {
    diagnostic.file = tool.file;
    diagnostic.line = tool.line;
  }
  report(who, diagnostic, tool.line);
}

void Collector::add(CatalogueTool tool) {
  if (!tool.number && tool.name.empty())
    tool.name = "tool at position " + std::to_string(made_.library.tools.size() + 1);
  const std::string who = tool_label(tool.number, tool.name);
  Diagnostics notes;
  Result<ToolAssembly> made = make_catalogue_tool(tool, options_, notes);
  if (!made && made.error().code == "import-shape")
    return report_of(tool, who, make_warning("import-shape", "not imported: shape " + made.error().message));
  for (const Diagnostic& note : notes) report_of(tool, who, note);
  if (!made) return report_of(tool, who, made.error());
  made->uncertainty = tool.uncertainty;
  if (!tool.uncertainty.empty()) report_of(tool, who, make_note("import-guess", tool.uncertainty));
  assign_number(*made, tool.line);
  is_all_inch_ = is_all_inch_ && tool.unit == LengthUnit::inch;
  made_.library.tools.push_back(std::move(*made));
}

void Collector::add_holder(NamedHolder holder, LengthUnit unit, std::size_t line) {
  const std::string who = "holder \"" + holder.name + "\"";
  const ToolAssembly probe{std::nullopt, holder.name, FlatCutter{1, 1}, {}, holder.segments};
  if (const Result<BodyProfiles> bodies = make_body_profiles(probe); !bodies) return report(who, bodies.error(), line);
  is_all_inch_ = is_all_inch_ && unit == LengthUnit::inch;
  made_.library.holders.push_back(std::move(holder));
}

ImportedTools Collector::finish() {
  const bool is_empty = made_.library.tools.empty() && made_.library.holders.empty();
  if (is_empty) made_.notes.push_back(make_error("import-empty", "no tool of this file could be imported", file()));
  for (const auto& [number, tools] : tools_of_number_)
    if (tools > 1) made_.library.shared_numbers.push_back(number);
  for (const auto& [name, tools] : tools_of_name_)
    if (tools > 1) made_.library.shared_names.push_back(name);
  made_.library.unit = is_all_inch_ && !is_empty ? LengthUnit::inch : LengthUnit::mm;
  return std::move(made_);
}

namespace {

namespace fs = std::filesystem;

// Returns the entries of a folder with this name: the entry with exactly this name, else all that differ from it in
// case alone.
std::vector<std::string> entries_called(const fs::path& folder, const std::string& name) {
  std::error_code failed;
  if (name == ".." || fs::exists(fs::symlink_status(folder / name, failed))) return {name};
  std::vector<std::string> found;
  for (fs::directory_iterator at(folder.empty() ? fs::path(".") : folder, failed), end; !failed && at != end;
       at.increment(failed)) {
    const std::string entry = at->path().filename().string();
    if (in_small_letters(entry) == in_small_letters(name)) found.push_back(entry);
  }
  std::ranges::sort(found);
  return found;
}

struct Place {
  fs::path path;
  std::optional<Diagnostic> ambiguous;
};

// Returns the path of `name` below `folder`, spelled as the entries of the folder. Returns it as given if there is no
// such file.
Place find_ignoring_case(const fs::path& folder, const fs::path& name) {
  fs::path at = folder;
  for (const fs::path& step : name) {
    const std::vector<std::string> found = entries_called(at, step.string());
    if (found.size() > 1)
      return {folder / name, make_error("import-beside",
                                        "no file has exactly this name, and '" + found[0] + "' and '" + found[1] +
                                            "' differ from it in case alone; rename one of them",
                                        (folder / name).string())};
    if (found.empty()) return {folder / name, std::nullopt};
    at /= found.front();
  }
  return {at, std::nullopt};
}

}  // namespace

Result<BesideFile> read_beside(const std::string& library_file, const std::string& name, std::uint64_t max_bytes) {
  const fs::path folder = fs::path(library_file).parent_path();
  std::vector<std::string> tried;
  for (const fs::path& below : {fs::path(), fs::path("..") / "Bit"}) {
    const Place place = find_ignoring_case(folder, below / name);
    if (place.ambiguous) return *place.ambiguous;
    tried.push_back(place.path.lexically_normal().string());
    Result<std::string> bytes = read_file(tried.back(), max_bytes);
    if (bytes) return BesideFile{tried.back(), std::move(*bytes)};
    if (bytes.error().code != "file-not-found") return bytes.error();
  }
  return make_error("file-not-found", "there is no such file, nor " + tried[1], tried[0]);
}

}  // namespace gouge

#include "toolmodels/import/collector.h"

#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include "lib/base/files.h"

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
  if (tool.uncertainty.empty() && tool.holder.empty()) made->uncertainty = options_.holder_uncertainty;
  if (made->holder.empty()) made->missing_holder = tool.missing_holder;
  if (!made->uncertainty.empty()) report_of(tool, who, make_note("import-guess", made->uncertainty));
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

Result<BesideFile> read_beside(const std::string& library_file, const std::string& name, std::uint64_t max_bytes,
                               SearchLog& searches) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::path(library_file).parent_path();
  const std::vector<std::string> found = find_files({SearchRule::named_by_tools, folder.string(), name}, searches);
  if (found.size() > 1) {
    const auto called = [&](std::size_t k) { return "'" + fs::path(found[k]).filename().string() + "'"; };
    return make_error("import-beside",
                      "no file has exactly this name, and " + called(0) + " and " + called(1) +
                          " differ from it in case alone; rename one of them",
                      (folder / name).string());
  }
  if (found.empty())
    return make_error("file-not-found",
                      "there is no such file, nor " + (folder / ".." / "Bit" / name).lexically_normal().string(),
                      (folder / name).lexically_normal().string());
  Result<std::string> bytes = read_file(found.front(), max_bytes);
  if (!bytes) return bytes.error();
  return BesideFile{found.front(), std::move(*bytes)};
}

}  // namespace gouge

#include <gougecheck/tool.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "cli/library/content.h"
#include "lib/base/files.h"
#include "lib/base/number_text.h"
#include "lib/check/reach.h"
#include "toolmodels/cutter_fields.h"
#include "toolmodels/import/import_tools.h"
#include "toolmodels/import/read_any_tools.h"

namespace gougecheck {
namespace {

using nlohmann::ordered_json;

ordered_json segments_json(const std::vector<ToolSegment>& segments) {
  ordered_json all = ordered_json::array();
  for (const ToolSegment& s : segments)
    all.push_back({{"lower_diameter", s.lower_diameter}, {"upper_diameter", s.upper_diameter}, {"length", s.length}});
  return all;
}

gouge::ToolLibrary library_of(const ordered_json& tool, const ordered_json& units) {
  const ordered_json library = {{"units", units}, {"tools", ordered_json::array({tool})}};
  return value_or_raise(gouge::read_tool_library("tool", library.dump()));
}

/// Throws for a dimension that the shape does not have, and for one that it needs. A shape that is not known passes.
void require_dimensions(std::string_view shape, const std::map<std::string, double>& dimensions) {
  const auto known = std::ranges::find_if(gouge::every_shape(),
                                          [&](const gouge::Cutter& one) { return gouge::shape_name(one) == shape; });
  if (known == gouge::every_shape().end()) return;
  gouge::Cutter cutter = *known;
  std::vector<std::string> all, missing;
  gouge::detail::visit_fields(cutter, [&](const gouge::detail::CutterField& field) {
    all.emplace_back(field.key);
    if (!field.otherwise && !dimensions.contains(field.key)) missing.emplace_back(field.key);
  });
  const std::string of_shape =
      "; the dimensions of the shape " + std::string(shape) + " are " + gouge::listed(all, " and ");
  for (const auto& [dimension, value] : dimensions) {
    if (std::ranges::find(all, dimension) == all.end())
      raise(gouge::make_error("tool-dimension-name", "there is no dimension '" + dimension + "'" + of_shape, "tool"));
  }
  if (!missing.empty())
    raise(gouge::make_error("tool-dimension-name", "the tool has no " + gouge::listed(missing, " and ") + of_shape,
                            "tool"));
}

std::string names_in(const gouge::ToolLibrary& library) {
  std::vector<std::string> names;
  for (const gouge::ToolAssembly& tool : library.tools) names.push_back(gouge::label(tool));
  return gouge::listed(names);
}

const gouge::ToolAssembly& tool_called(const gouge::ToolLibrary& library, std::string_view name) {
  if (name.empty() && library.tools.size() == 1) return library.tools.front();
  if (const std::string two = library.two_tools_called(name); !two.empty())
    raise(gouge::make_error("library-which", "'" + std::string(name) + "' is " + two, library.file));
  if (const gouge::ToolAssembly* tool = name.empty() ? nullptr : library.called(name)) return *tool;
  const std::string asked = name.empty() ? "several tools and no name" : "no tool called '" + std::string(name) + "'";
  raise(gouge::make_error("library-which", asked + "; expected the name or number of one of " + names_in(library),
                          library.file));
}

gouge::ImportOptions import_options(const ImportFacts& facts, const std::string& file, std::string_view bytes) {
  gouge::ImportOptions options;
  if (!facts.stickout && facts.unit.empty()) return options;
  if (!gouge::recognise_format(bytes))
    raise(gouge::make_error("usage",
                            "stickout and unit are facts about a library of another program; this file is none", file));
  options.unit = gouge::unit_called(facts.unit);
  const bool is_unit = options.unit == gouge::LengthUnit::mm || options.unit == gouge::LengthUnit::inch;
  if (!facts.unit.empty() && !is_unit)
    raise(gouge::make_error("usage", "unit '" + facts.unit + "': expected mm or inch", file));
  if (facts.stickout && !(*facts.stickout > 0 && *facts.stickout <= gouge::kFarthest_mm))
    raise(gouge::make_error("usage", "stickout: expected a length above 0, in mm", file));
  options.stickout_mm = facts.stickout;
  return options;
}

}  // namespace

Tool::Tool(std::shared_ptr<const Content> content) : content_(std::move(content)) {}

Tool::Tool(std::string_view shape, const std::map<std::string, double>& dimensions,
           const std::vector<ToolSegment>& shank, const std::vector<ToolSegment>& holder, std::string_view name) {
  ordered_json cutter = {{"shape", shape}};
  for (const auto& [dimension, value] : dimensions) cutter[dimension] = value;
  ordered_json tool = {{"name", name.empty() ? shape : name}, {"cutter", cutter}};
  if (!shank.empty()) tool["shank"] = segments_json(shank);
  if (!holder.empty()) tool["holder"] = segments_json(holder);
  require_dimensions(shape, dimensions);
  gouge::ToolLibrary library = library_of(tool, "mm");
  content_ = std::make_shared<Content>(Content{std::move(library.tools.front())});
}

Tool Tool::from_json(std::string_view json, std::string_view name) {
  const ordered_json read = ordered_json::parse(json, nullptr, false);
  gouge::ToolLibrary library;
  if (read.is_object() && read.contains("cutter") && !read.contains("tools")) {
    ordered_json tool = read;
    tool.erase("units");
    if (!tool.contains("name") && !tool.contains("number")) tool["name"] = "tool";
    library = library_of(tool, read.contains("units") ? read["units"] : ordered_json());
  } else {
    library = value_or_raise(gouge::read_tool_library("tools", json));
  }
  return Tool(std::make_shared<Content>(Content{tool_called(library, name)}));
}

const std::string& Tool::name() const { return content_->assembly.name; }
bool Tool::has_holder() const { return !content_->assembly.holder.empty(); }
double Tool::height() const { return gouge::height_mm(content_->assembly); }

std::string Tool::to_json() const {
  gouge::ToolLibrary library;
  library.tools = {content_->assembly};
  return gouge::write_tool_library(library);
}

ToolLibrary::ToolLibrary(std::shared_ptr<const Content> content) : content_(std::move(content)) {}

ToolLibrary ToolLibrary::read(const std::string& file, const ImportFacts& facts) {
  const std::string bytes = value_or_raise(gouge::read_file(file));
  const gouge::ImportOptions options = import_options(facts, file, bytes);
  gouge::SearchLog searches;
  gouge::ReadTools read = value_or_raise(gouge::read_any_tools(file, bytes, gouge::kMaxInputBytes, searches, options));
  std::vector<gouge::InputFile> files = {gouge::describe_input("tools", file, bytes)};
  for (const gouge::BesideFile& beside : read.besides)
    files.push_back(gouge::describe_input("named-by-tools", beside.path, beside.bytes));
  const bool is_by_facts = facts.stickout || !facts.unit.empty();
  return ToolLibrary(std::make_shared<Content>(Content{std::move(read.library), std::move(files), is_by_facts}));
}

ToolLibrary ToolLibrary::from_json(std::string_view json, const std::string& name) {
  return ToolLibrary(std::make_shared<Content>(Content{value_or_raise(gouge::read_tool_library(name, json))}));
}

ToolLibrary::ToolLibrary(const std::vector<Tool>& tools) {
  gouge::ToolLibrary library;
  for (const Tool& tool : tools) library.tools.push_back(tool.content().assembly);
  // Reads it as a file, so that the same rules hold.
  content_ = from_json(gouge::write_tool_library(library)).content_;
}

ToolLibrary ToolLibrary::empty() { return ToolLibrary(std::make_shared<Content>()); }

bool ToolLibrary::has(std::string_view name) const {
  return content_->library.called(name) != nullptr && content_->library.two_tools_called(name).empty();
}
std::vector<Note> ToolLibrary::notes() const { return to_notes(content_->library.notes); }
std::string ToolLibrary::to_json() const { return gouge::write_tool_library(content_->library); }

std::vector<Tool> ToolLibrary::tools() const {
  std::vector<Tool> all;
  for (const gouge::ToolAssembly& tool : content_->library.tools)
    all.push_back(Tool(std::make_shared<Tool::Content>(Tool::Content{tool})));
  return all;
}

Tool ToolLibrary::tool(std::string_view name) const {
  return Tool(std::make_shared<Tool::Content>(Tool::Content{tool_called(content_->library, name)}));
}

std::vector<std::string> tool_shapes() {
  std::vector<std::string> names;
  for (const gouge::Cutter& cutter : gouge::every_shape()) names.emplace_back(gouge::shape_name(cutter));
  return names;
}

}  // namespace gougecheck

#include <algorithm>
#include <cmath>

#include "lib/base/number_text.h"
#include "toolmodels/import/collector.h"
#include "toolmodels/import/import_tools.h"
#include "toolmodels/import/json_entry.h"

// CAMotics: an object of tools by their numbers, alone or as "tools" of a project.

namespace gouge {
namespace {

using Json = nlohmann::json;

const Json& tools_of(const Json& root) {
  const auto tools = root.find("tools");
  return tools != root.end() && tools->is_object() ? *tools : root;
}

class CamoticsImporter {
 public:
  explicit CamoticsImporter(Collector& collector) : collector_(collector) {}

  void read(const std::string& key, const Json& entry, std::size_t line) {
    tool_ = {};
    tool_.line = line;
    if (const auto number = parse_integer(key)) tool_.number = tool_number(*number);
    tool_.name = detail::text_of(entry, "description");
    collector_.count(tool_.number, tool_.name);
    who_ = tool_label(tool_.number, tool_.name.empty() ? key : tool_.name);
    if (!entry.is_object()) return report(make_error("import-field", "is no object; expected a tool"));
    const Outcome read = read_unit(entry);
    if (!read) return report(read.error());
    const std::string shape = plain_word(detail::text_of(entry, "shape"));
    if (const Outcome made = read_lengths(entry, shape); !made) return report(made.error());
    if (!take_shape(shape)) return collector_.leave_out(who_, shape.empty() ? "not named" : shape, line);
    collector_.add(tool_);
  }

 private:
  void report(const Diagnostic& what) { collector_.report(who_, what, tool_.line); }

  Outcome read_unit(const Json& entry) {
    const std::string units = plain_word(detail::text_of(entry, "units"));
    if (units != "metric" && units != "imperial" && units != "mm" && units != "inch")
      return make_error("import-field", "units is \"" + units + "\"; expected \"metric\" or \"imperial\"");
    tool_.unit = units == "metric" || units == "mm" ? LengthUnit::mm : LengthUnit::inch;
    return Done{};
  }

  Outcome read_lengths(const Json& entry, const std::string& shape) {
    const bool has_snub = shape == "snubnose";
    for (const auto& [key, dimension] : {std::pair("diameter", Dimension::diameter),
                                         {"length", Dimension::flute_length},
                                         {"snub_diameter", Dimension::tip_diameter}}) {
      if (dimension == Dimension::tip_diameter && !has_snub) continue;
      const auto value = entry.find(key);
      const double length = value != entry.end() && value->is_number() ? value->get<double>() : 0;
      if (!(length > 0)) return make_error("import-field", std::string("has no ") + key + " above 0");
      tool_.dimensions.set(dimension, length * mm_per(tool_.unit), key);
    }
    tool_.dimensions.set(Dimension::body_length, tool_.dimensions[Dimension::flute_length]->value, "length");
    return Done{};
  }

  // Returns false for a shape that cannot be expressed.
  bool take_shape(const std::string& shape) {
    tool_.shape = CatalogueShape::flat;
    if (shape == "cylindrical") return true;
    if (shape == "ballnose") {
      tool_.shape = CatalogueShape::ball;
      return true;
    }
    if (shape != "conical" && shape != "snubnose") return false;
    tool_.shape = CatalogueShape::chamfer;
    const double tip = tool_.dimensions.value_or(Dimension::tip_diameter, 0);
    const double half = (tool_.dimensions[Dimension::diameter]->value - tip) / 2;
    if (shape == "conical") tool_.dimensions.set(Dimension::tip_diameter, 0, "tip");
    tool_.dimensions.set(Dimension::taper_angle,
                         std::atan2(half, tool_.dimensions[Dimension::flute_length]->value) / kDegree_rad, "diameter");
    return half > 0;
  }

  Collector& collector_;
  CatalogueTool tool_;
  std::string who_;
};

}  // namespace

Result<ImportedTools> import_camotics(const std::string& file, std::string_view bytes, const ImportOptions& options) {
  const Result<JsonFile> json = parse_json(file, bytes, detail::imported_kind("a tool table of CAMotics"));
  if (!json) return json.error();
  Collector collector(file, options);
  CamoticsImporter importer(collector);
  const bool is_project = &tools_of(json->root) != &json->root;
  for (const auto& [key, entry] : tools_of(json->root).items())
    importer.read(key, entry, json->lines.at((is_project ? "/tools/" : "/") + key));
  return collector.finish();
}

namespace detail {

bool is_camotics_table(const nlohmann::json& root) {
  if (!root.is_object()) return false;
  const nlohmann::json& tools = tools_of(root);
  const auto is_tool = [](const nlohmann::json& one) {
    return one.is_object() && one.contains("shape") && one.contains("diameter") && one.contains("units");
  };
  return !tools.empty() && std::all_of(tools.begin(), tools.end(), is_tool);
}

}  // namespace detail
}  // namespace gouge

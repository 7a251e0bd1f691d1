#include <algorithm>
#include <cmath>
#include <utility>

#include "toolmodels/import/collector.h"
#include "toolmodels/import/import_tools.h"
#include "toolmodels/import/json_entry.h"
#include "toolmodels/import/read_any_tools.h"

namespace gouge {
namespace {

using Json = nlohmann::json;

constexpr double kAgree_mm = 5e-3;

std::optional<CatalogueShape> fusion_shape(const std::string& word) {
  static constexpr std::pair<std::string_view, CatalogueShape> kShapes[] = {
      {"flatendmill", CatalogueShape::flat},
      {"ballendmill", CatalogueShape::ball},
      {"bullnoseendmill", CatalogueShape::bull_nose},
      {"taperedmill", CatalogueShape::tapered},
      {"chamfermill", CatalogueShape::chamfer},
      {"countersink", CatalogueShape::chamfer},
      {"facemill", CatalogueShape::face},
      {"drill", CatalogueShape::drill},
      {"spotdrill", CatalogueShape::drill},
      {"reamer", CatalogueShape::flat},
      {"slotmill", CatalogueShape::slot},
      {"dovetailmill", CatalogueShape::dovetail},
      {"lollipopmill", CatalogueShape::lollipop},
      {"radiusmill", CatalogueShape::radius},
      {"centerdrill", CatalogueShape::center_drill},
      {"circlesegmentbarrel", CatalogueShape::barrel},
      {"circlesegmentoval", CatalogueShape::oval},
      {"circlesegmentlens", CatalogueShape::lens},
      {"circlesegmenttaper", CatalogueShape::taper_segment},
      {"probe", CatalogueShape::probe},
      {"counterbore", CatalogueShape::flat},
      {"boringbar", CatalogueShape::full},
      {"threadmill", CatalogueShape::full},
      {"taprighthand", CatalogueShape::full},
      {"taplefthand", CatalogueShape::full}};
  for (const auto& [name, shape] : kShapes)
    if (name == word) return shape;
  return std::nullopt;
}

// Returns whether a key of `geometry` has no effect on the contour of the shapes above.
bool is_no_fusion_contour(const std::string& key) {
  static constexpr std::string_view kKeys[] = {"NOF",
                                               "NT",
                                               "HAND",
                                               "CSP",
                                               "TP",
                                               "assemblyGaugeLength",
                                               "thread-profile-angle",
                                               "thread-tip-type",
                                               "TPN",
                                               "TPX",
                                               "tip-offset",
                                               "shoulder-height"};
  return std::find(std::begin(kKeys), std::end(kKeys), key) != std::end(kKeys);
}

class FusionImporter {
 public:
  FusionImporter(Collector& collector, const JsonLines& lines) : collector_(collector), lines_(lines) {}

  void entry(const Json& entry, const std::string& pointer, std::size_t position) {
    if (!entry.is_object())
      return collector_.report("entry " + std::to_string(position),
                               make_error("import-field", "is no object; expected a tool or a holder"),
                               lines_.at(pointer));
    CatalogueTool tool;
    tool.line = lines_.at(pointer);
    tool.name = text_of_first(entry, {"description", "product-id", "guid"});
    const std::string type = detail::text_of(entry, "type");
    if (plain_word(type) == "holder") return holder_entry(entry, tool, position);
    read_number(entry, tool);
    collector_.count(tool.number, tool.name);
    if (!tool.number && tool.name.empty()) tool.name = "entry " + std::to_string(position);
    who_ = tool_label(tool.number, tool.name);
    line_ = tool.line;
    const std::optional<CatalogueShape> shape = fusion_shape(plain_word(type));
    if (!shape) return collector_.leave_out(who_, type.empty() ? "not named" : type, line_);
    tool.shape = *shape;
    if (const Outcome good = read_tool(entry, tool); !good) return collector_.report(who_, good.error(), line_);
    collector_.add(std::move(tool));
  }

 private:
  static std::string text_of_first(const Json& entry, std::initializer_list<const char*> keys) {
    for (const char* key : keys)
      if (std::string text = detail::text_of(entry, key); !text.empty()) return text;
    return {};
  }

  void holder_entry(const Json& entry, CatalogueTool& tool, std::size_t position) {
    if (tool.name.empty()) tool.name = "holder " + std::to_string(position);
    who_ = "holder \"" + tool.name + "\"";
    line_ = tool.line;
    const Result<LengthUnit> unit = unit_of(entry, std::nullopt);
    if (!unit) return collector_.report(who_, unit.error(), line_);
    const Result<std::vector<ToolSegment>> segments = read_segments(entry, "holder", *unit);
    if (!segments) return collector_.report(who_, segments.error(), line_);
    if (segments->empty())
      return collector_.report(who_, make_error("import-field", "has no segments; it needs at least one"), line_);
    check_gauge_length(entry, *segments, *unit);
    collector_.add_holder({tool.name, *segments}, *unit, line_);
  }

  static void read_number(const Json& entry, CatalogueTool& tool) {
    const auto post = entry.find("post-process");
    if (post == entry.end() || !post->is_object()) return;
    const auto number = post->find("number");
    if (number != post->end() && number->is_number_integer()) tool.number = tool_number(number->get<std::int64_t>());
  }

  static Result<LengthUnit> unit_of(const Json& entry, std::optional<LengthUnit> otherwise) {
    const std::string word = detail::text_of(entry, "unit");
    if (word == "millimeters") return LengthUnit::mm;
    if (word == "inches") return LengthUnit::inch;
    if (otherwise && !entry.contains("unit")) return *otherwise;
    return make_error("import-field", entry.contains("unit")
                                          ? "unit is \"" + word + "\"; expected \"millimeters\" or \"inches\""
                                          : "has no \"unit\"; each entry needs its own");
  }

  Outcome read_tool(const Json& entry, CatalogueTool& tool) {
    const Result<LengthUnit> unit = unit_of(entry, std::nullopt);
    if (!unit) return unit.error();
    tool.unit = *unit;
    const auto geometry = entry.find("geometry");
    if (geometry == entry.end() || !geometry->is_object())
      return make_error("import-field", "has no \"geometry\"; it needs one");
    if (Outcome good = read_geometry(*geometry, tool); !good) return good;
    if (const auto shaft = entry.find("shaft"); shaft != entry.end() && !shaft->is_null()) {
      if (!shaft->is_object()) return make_error("import-field", "its shaft is no object; expected one with segments");
      const Result<LengthUnit> shaft_unit = unit_of(*shaft, *unit);
      if (!shaft_unit) return shaft_unit.error();
      Result<std::vector<ToolSegment>> segments = read_segments(*shaft, "shaft", *shaft_unit);
      if (!segments) return segments.error();
      tool.shaft = std::move(*segments);
    }
    return read_holder(entry, *geometry, tool);
  }

  Outcome read_holder(const Json& entry, const Json& geometry, CatalogueTool& tool) {
    const auto holder = entry.find("holder");
    if (holder == entry.end() || holder->is_null() || *holder == "") return Done{};
    if (!holder->is_object()) {
      const std::string name = holder->is_string() ? " \"" + detail::text_of(entry, "holder") + "\"" : "";
      miss_holder(tool, "its holder" + name + " is not described in its entry, and is left out");
      return Done{};
    }
    const Result<LengthUnit> unit = unit_of(*holder, tool.unit);
    if (!unit) return Diagnostic(unit.error());
    Result<std::vector<ToolSegment>> segments = read_segments(*holder, "holder", *unit);
    if (!segments) return segments.error();
    tool.holder = std::move(*segments);
    if (tool.holder.empty()) miss_holder(tool, "its holder has no segments");
    const double gauge_mm = check_gauge_length(*holder, tool.holder, *unit);
    check_assembly_length(geometry, tool, gauge_mm);
    return Done{};
  }

  Outcome read_geometry(const Json& geometry, CatalogueTool& tool) {
    for (const auto& [key, value] : geometry.items()) {
      std::optional<Dimension> dimension = catalogue_dimension(key);
      if (!dimension) {
        if (!is_no_fusion_contour(key))
          report(make_note("import-left-out", "geometry has a key \"" + clean_text(key) +
                                                  "\" that has no meaning for this shape here and was left out"));
        continue;
      }
      const Result<std::optional<Quantity>> quantity = detail::quantity_of(value, key, tool.unit, is_angle(*dimension));
      if (!quantity) return quantity.error();
      if (!*quantity) continue;
      if (const std::optional<Given>& before = tool.dimensions[*dimension];
          before && std::abs(before->value - (*quantity)->value) > kAgree_mm)
        return make_error("import-field",
                          key + " and " + before->key + " are two names of one dimension, but have different values");
      tool.dimensions.set(*dimension, (*quantity)->value, key);
    }
    if (tool.shape == CatalogueShape::chamfer) take_half_of_point_angle(tool.dimensions);
    return Done{};
  }

  // Takes the taper angle of a countersink from its point angle, which Fusion stores instead.
  static void take_half_of_point_angle(Dimensions& d) {
    const bool has_taper = d.value_or(Dimension::taper_angle, 0) > 0;
    if (has_taper || !d[Dimension::point_angle]) return;
    const Given point = *d[Dimension::point_angle];
    d.set(Dimension::taper_angle, point.value / 2, "half of " + point.key);
  }

  static Result<std::vector<ToolSegment>> read_segments(const Json& owner, const std::string& what, LengthUnit unit) {
    std::vector<ToolSegment> segments;
    const auto list = owner.find("segments");
    if (list == owner.end() || list->is_null()) return segments;
    if (!list->is_array()) return make_error("import-field", what + ": segments is no list");
    for (std::size_t i = 0; i < list->size(); ++i) {
      const std::string which = what + " segment " + std::to_string(i + 1) + ": ";
      double values[3] = {};
      const char* keys[3] = {"lower-diameter", "upper-diameter", "height"};
      for (int k = 0; k < 3; ++k) {
        const Json& segment = (*list)[i];
        const auto found = segment.is_object() ? segment.find(keys[k]) : segment.end();
        if (found == segment.end())
          return make_error("import-field", which + "has no \"" + keys[k] + "\"; it needs one");
        const Result<std::optional<Quantity>> quantity = detail::quantity_of(*found, which + keys[k], unit, false);
        if (!quantity) return quantity.error();
        if (!*quantity || !((*quantity)->value > 0))
          return make_error("import-field", which + keys[k] + " is not above 0");
        values[k] = (*quantity)->value;
      }
      segments.push_back({values[0], values[1], values[2]});
    }
    return segments;
  }

  void miss_holder(CatalogueTool& tool, const std::string& why) {
    tool.missing_holder = why;
    report(make_warning("import-left-out", why + "; give a holder with --holder"));
  }

  // Checks the gauge length. Segments above the gauge line are inside the spindle; they are kept, because they only
  // enlarge the tool.
  double check_gauge_length(const Json& holder, const std::vector<ToolSegment>& segments, LengthUnit unit) {
    const auto found = holder.find("gaugeLength");
    if (found == holder.end() || !found->is_number() || segments.empty()) return 0;
    const double gauge_mm = found->get<double>() * mm_per(unit);
    double total_mm = 0;
    for (const ToolSegment& s : segments) total_mm += s.length_mm;
    const std::string gauge = "gaugeLength " + mm_text(gauge_mm);
    if (gauge_mm > total_mm + kAgree_mm)
      report(make_warning("import-contradiction", gauge + " is more than the holder's segments together, " +
                                                      mm_text(total_mm) +
                                                      "; the part of the holder above them is not in the file"));
    else if (gauge_mm > 0 && gauge_mm < total_mm - kAgree_mm)
      report(make_note("import-guess", "the holder's segments reach " + mm_text(total_mm - gauge_mm) +
                                           " above the gauge line; they are kept"));
    return gauge_mm;
  }

  void check_assembly_length(const Json& geometry, const CatalogueTool& tool, double gauge_mm) {
    const auto found = geometry.find("assemblyGaugeLength");
    const double body_mm = tool.dimensions.value_or(Dimension::body_length, 0);
    if (found == geometry.end() || !found->is_number() || !(gauge_mm > 0) || !(body_mm > 0)) return;
    const double assembly_mm = found->get<double>() * mm_per(tool.unit);
    if (!(assembly_mm > 0) || std::abs(assembly_mm - body_mm - gauge_mm) <= kAgree_mm) return;
    report(make_warning("import-contradiction", "assemblyGaugeLength " + mm_text(assembly_mm) + " is not " +
                                                    tool.dimensions.text(Dimension::body_length) + " and gaugeLength " +
                                                    mm_text(gauge_mm) + " together; built from these two"));
  }

  void report(const Diagnostic& diagnostic) { collector_.report(who_, diagnostic, line_); }

  Collector& collector_;
  const JsonLines& lines_;
  std::string who_;
  std::size_t line_ = 0;
};

}  // namespace

Result<ImportedTools> import_fusion(const std::string& file, std::string_view bytes, const ImportOptions& options) {
  std::string unzipped;
  if (is_zip(bytes)) {
    Result<std::string> content = unzip_first(file, bytes, ".json");
    if (!content) return content.error();
    unzipped = std::move(*content);
    bytes = unzipped;
  }
  const Result<JsonFile> json = parse_json(file, bytes, detail::imported_kind("a Fusion tool library"));
  if (!json) return json.error();
  const auto data = json->root.find("data");
  if (data == json->root.end() || !data->is_array())
    return make_error("import-format", "this JSON has no list \"data\"; expected a Fusion tool library", file);
  Collector collector(file, options);
  FusionImporter importer(collector, json->lines);
  for (std::size_t i = 0; i < data->size(); ++i) importer.entry((*data)[i], "/data/" + std::to_string(i), i + 1);
  return collector.finish();
}

}  // namespace gouge

#include <algorithm>
#include <utility>

#include "toolmodels/import/collector.h"
#include "toolmodels/import/import_tools.h"
#include "toolmodels/import/json_entry.h"

namespace gouge {
namespace {

using Json = nlohmann::json;

std::optional<CatalogueShape> freecad_shape(const std::string& word) {
  static constexpr std::pair<std::string_view, CatalogueShape> kShapes[] = {
      {"endmill", CatalogueShape::flat},
      {"ballend", CatalogueShape::ball},
      {"ballnose", CatalogueShape::ball},
      {"bullnose", CatalogueShape::bull_nose},
      {"chamfer", CatalogueShape::chamfer},
      {"vbit", CatalogueShape::chamfer},
      {"drill", CatalogueShape::drill},
      {"reamer", CatalogueShape::flat},
      {"taperedballnose", CatalogueShape::tapered_ball},
      {"torus", CatalogueShape::bull_nose},
      {"dovetail", CatalogueShape::dovetail},
      {"slittingsaw", CatalogueShape::saw},
      {"probe", CatalogueShape::probe},
      {"tap", CatalogueShape::full}};
  for (const auto& [name, shape] : kShapes)
    if (name == word) return shape;
  return std::nullopt;
}

// Returns which of two shapes with the dimensions of one file contains the other; nothing if neither does.
std::optional<CatalogueShape> larger_shape(CatalogueShape a, CatalogueShape b) {
  using enum CatalogueShape;
  // Each of these contains all that follow: a full cylinder of the flutes, then cylinders with rounded corners or a
  // round end.
  static constexpr CatalogueShape kMills[] = {full, flat, bull_nose, ball};
  const auto rank = [](CatalogueShape shape) { return std::find(std::begin(kMills), std::end(kMills), shape); };
  if (rank(a) != std::end(kMills) && rank(b) != std::end(kMills)) return rank(a) < rank(b) ? a : b;
  const auto is_cylinder = [](CatalogueShape shape) { return shape == full || shape == flat; };
  const auto is_pointed = [](CatalogueShape shape) { return shape == drill || shape == chamfer; };
  if (is_cylinder(a) && is_pointed(b)) return a;
  if (is_cylinder(b) && is_pointed(a)) return b;
  return std::nullopt;
}

// A parameter of FreeCAD. Its angles of tapers and edges are INCLUDED angles; those of the catalogue are half of them.
struct Parameter {
  Dimension dimension;
  double factor = 1;
};

std::optional<Parameter> parameter_of(const std::string& key) {
  static constexpr std::pair<std::string_view, Parameter> kNames[] = {
      {"Diameter", {Dimension::diameter}},
      {"CornerRadius", {Dimension::corner_radius}},
      {"TorusRadius", {Dimension::corner_radius}},
      {"CuttingEdgeHeight", {Dimension::flute_length}},
      {"CuttingEdgeLength", {Dimension::flute_length}},
      {"Length", {Dimension::overall_length}},
      {"ShankDiameter", {Dimension::shank_diameter}},
      {"TaperAngle", {Dimension::taper_angle, 0.5}},
      {"CuttingEdgeAngle", {Dimension::taper_angle, 0.5}},
      {"TipAngle", {Dimension::point_angle}},
      {"TipDiameter", {Dimension::tip_diameter}},
      {"TaperDiameter", {Dimension::largest_diameter}},
      {"BladeThickness", {Dimension::flute_length}},
      {"CapDiameter", {Dimension::cap_diameter}},
      {"CapHeight", {Dimension::cap_height}},
      {"NeckDiameter", {Dimension::shoulder_diameter}},
      {"ShaftDiameter", {Dimension::shank_diameter}}};
  for (const auto& [name, parameter] : kNames)
    if (name == key) return parameter;
  if (const std::optional<Dimension> dimension = catalogue_dimension(key)) return Parameter{*dimension};
  return std::nullopt;
}

bool is_no_freecad_contour(const std::string& key) {
  static constexpr std::string_view kKeys[] = {"Flutes",   "Units",    "Material", "SpindleDirection",
                                               "Chipload", "ChipLoad", "Pitch",    "Coating"};
  return std::find(std::begin(kKeys), std::end(kKeys), key) != std::end(kKeys);
}

std::string stem(const std::string& path) {
  const std::size_t slash = path.find_last_of("/\\");
  const std::string name = slash == std::string::npos ? path : path.substr(slash + 1);
  return name.substr(0, name.find_last_of('.'));
}

class BitImporter {
 public:
  BitImporter(Collector& collector, const JsonFile& json, std::string file)
      : collector_(collector), json_(json), file_(std::move(file)) {}

  void read(std::optional<int> number) {
    tool_.number = number;
    tool_.name = detail::text_of(json_.root, "name");
    if (tool_.name.empty()) tool_.name = clean_text(stem(file_));
    collector_.count(std::nullopt, tool_.name);  // its number is counted with its entry in the library
    tool_.file = file_;
    who_ = tool_label(tool_.number, tool_.name);
    if (!read_shape()) return;
    const auto parameters = json_.root.find("parameter");
    if (parameters == json_.root.end() || !parameters->is_object())
      return report(make_error("import-field", "has no \"parameter\"; it needs them"));
    if (const Outcome good = read_parameters(*parameters); !good) return report(good.error());
    tool_.unit = has_inch_ && !has_mm_ ? LengthUnit::inch : LengthUnit::mm;
    collector_.add(std::move(tool_));
  }

 private:
  // Reads the shape, which both "shape-type" and the name of the file in "shape" may state.
  bool read_shape() {
    std::string type = detail::text_of(json_.root, "shape-type");
    const std::string file_name = stem(detail::text_of(json_.root, "shape"));
    if (type.empty()) type = file_name;
    const std::optional<CatalogueShape> by_type = freecad_shape(plain_word(type));
    const std::optional<CatalogueShape> by_file = freecad_shape(plain_word(file_name));
    if (!by_type) {
      report(make_warning("import-shape", "not imported: shape " + (type.empty() ? "not named" : type)));
      return false;
    }
    tool_.shape = *by_type;
    if (!by_file || *by_file == *by_type) return true;
    const std::string contradiction = "\"shape\" is " + file_name + " but \"shape-type\" is " + type;
    const std::optional<CatalogueShape> larger = larger_shape(*by_type, *by_file);
    if (!larger) {
      report(make_error("import-field", contradiction + "; correct the one that is wrong"));
      return false;
    }
    tool_.shape = *larger;
    report(make_warning("import-contradiction", contradiction + "; built as " + (larger == by_type ? type : file_name) +
                                                    ", which is the larger tool"));
    return true;
  }

  Outcome read_parameters(const Json& parameters) {
    std::optional<double> flat_radius, neck_height;
    for (const auto& [key, value] : parameters.items()) {
      if (is_no_freecad_contour(key)) continue;
      const std::optional<Parameter> parameter = parameter_of(key);
      if (!parameter && key != "FlatRadius" && key != "NeckHeight") {
        report(make_note("import-left-out", "has a parameter \"" + clean_text(key) +
                                                "\" that has no meaning for this shape here and was left out"));
        continue;
      }
      const bool angle = parameter && is_angle(parameter->dimension);
      const Result<std::optional<Quantity>> read = detail::quantity_of(value, key, LengthUnit::mm, angle);
      if (!read) return read.error();
      if (!*read) continue;
      note_how_it_reads(key, **read, angle);
      if (parameter)
        tool_.dimensions.set(parameter->dimension, (*read)->value * parameter->factor,
                             parameter->factor < 1 ? "half of " + key : key);
      else
        (key == "NeckHeight" ? neck_height : flat_radius) = (*read)->value;
    }
    if (flat_radius) take_corner_from_flat(*flat_radius);
    Dimensions& d = tool_.dimensions;
    if (neck_height)
      d.set(Dimension::shoulder_length, d.value_or(Dimension::flute_length, 0) + *neck_height,
            "CuttingEdgeHeight + NeckHeight");
    if (tool_.shape == CatalogueShape::dovetail) report_dovetail_angle(d);
    return Done{};
  }

  // Reports how the angle of a dovetail is read. Half of an included angle is equal to 90 degrees minus the angle from
  // the bottom only if both angles are 60 degrees. FreeCAD labels the tip diameter of a dovetail as a height; the
  // importer uses it neither as a diameter nor as a height.
  void report_dovetail_angle(Dimensions& d) {
    if (!d[Dimension::taper_angle]) return;
    report(make_warning("import-guess", d.text(Dimension::taper_angle) +
                                            " is taken between side and axis; if the angle of your "
                                            "dovetail is counted from its bottom, correct taper_angle"));
  }

  // Sets the corner radius of a bull nose from the radius of its flat, which old versions of the file state instead.
  void take_corner_from_flat(double flat_radius_mm) {
    if (tool_.dimensions[Dimension::corner_radius]) return;
    const double corner = tool_.dimensions.value_or(Dimension::diameter, 0) / 2 - flat_radius_mm;
    tool_.dimensions.set(Dimension::corner_radius, corner, "corner radius (Diameter/2 - FlatRadius)");
  }

  void note_how_it_reads(const std::string& key, const Quantity& quantity, bool angle) {
    if (quantity.unit == QuantityUnit::mm) has_mm_ = true;
    if (quantity.unit == QuantityUnit::inch) has_inch_ = true;
    if (quantity.has_decimal_comma)
      report(make_note("import-guess", key + " has a comma; read as a decimal comma, " +
                                           (angle ? degrees_text(quantity.value) : mm_text(quantity.value))));
    if (quantity.unit == QuantityUnit::none && !angle) {
      has_mm_ = true;
      report(make_note("import-guess", key + " has no unit; taken as " + mm_text(quantity.value)));
    }
  }

  void report(Diagnostic diagnostic) {
    diagnostic.message = who_ + ": " + diagnostic.message;
    diagnostic.file = file_;
    collector_.report(who_, diagnostic, 0);
  }

  Collector& collector_;
  const JsonFile& json_;
  std::string file_;
  CatalogueTool tool_;
  std::string who_;
  bool has_mm_ = false, has_inch_ = false;
};

// Returns whether the path stays below the folder of the library; files elsewhere are not read for it.
bool stays_below(const std::string& path) {
  return !path.empty() && path.front() != '/' && path.find('\\') == std::string::npos &&
         path.find("..") == std::string::npos && path.find(':') == std::string::npos &&
         path.find('\0') == std::string::npos;
}

void read_listed(Collector& collector, const Json& entry, const std::string& who, std::size_t line) {
  std::optional<int> number;
  if (const auto found = entry.find("nr"); found != entry.end() && found->is_number_integer())
    number = tool_number(found->get<std::int64_t>());
  collector.count(number, {});
  const std::string path = entry.is_object() ? detail::text_of(entry, "path") : std::string();
  if (!stays_below(path))
    return collector.report(
        who, make_error("import-field", "path is \"" + path + "\"; expected the name of a file beside the library"),
        line);
  if (!collector.options().read_beside)
    return collector.report(who, make_error("import-field", path + " cannot be read from here"), line);
  const Result<std::string> bytes = collector.options().read_beside(path);
  if (!bytes) return collector.report(who, bytes.error(), line);
  const Result<JsonFile> bit = parse_json(path, *bytes, detail::imported_kind("a FreeCAD tool bit"));
  if (!bit) return collector.report(who, bit.error(), line);
  if (!detail::is_freecad_bit(bit->root))
    return collector.report(who, make_error("import-format", "this is no FreeCAD tool bit", path), line);
  BitImporter(collector, *bit, path).read(number);
}

}  // namespace

Result<ImportedTools> import_freecad(const std::string& file, std::string_view bytes, const ImportOptions& options) {
  const Result<JsonFile> json = parse_json(file, bytes, detail::imported_kind("a FreeCAD tool bit or library"));
  if (!json) return json.error();
  Collector collector(file, options);
  if (detail::is_freecad_bit(json->root)) {
    BitImporter(collector, *json, file).read(std::nullopt);
    return collector.finish();
  }
  if (!detail::is_freecad_library(json->root))
    return make_error("import-format",
                      "expected a FreeCAD tool bit (with \"shape\" and \"parameter\") or a library (with a list "
                      "\"tools\" of files, each a \"path\")",
                      file);
  const auto tools = json->root.find("tools");
  for (std::size_t i = 0; i < tools->size(); ++i)
    read_listed(collector, (*tools)[i], "tool at position " + std::to_string(i + 1),
                json->lines.at("/tools/" + std::to_string(i)));
  return collector.finish();
}

}  // namespace gouge

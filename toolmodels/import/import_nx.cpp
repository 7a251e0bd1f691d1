#include <algorithm>
#include <map>
#include <utility>

#include "lib/base/number_text.h"
#include "toolmodels/import/collector.h"
#include "toolmodels/import/import_tools.h"
#include "toolmodels/import/nx_database.h"
#include "toolmodels/import/nx_holders.h"
#include "toolmodels/import/quantity.h"

namespace gouge {
namespace {

std::optional<CatalogueShape> nx_shape(const std::string& tool_class) {
  static constexpr std::pair<std::string_view, CatalogueShape> kClasses[] = {
      {"END_MILL_NON_INDEXABLE", CatalogueShape::five_numbers},
      {"END_MILL_INDEXABLE", CatalogueShape::five_numbers},
      {"UG_5_PARAMETER", CatalogueShape::five_numbers},
      {"FACE_MILL_INDEXABLE", CatalogueShape::five_numbers},
      {"BALL_MILL_NON_INDEXABLE", CatalogueShape::ball},
      {"TWIST_DRILL", CatalogueShape::drill},
      {"SPIRAL_DRILL", CatalogueShape::drill},
      {"INSERT_DRILL", CatalogueShape::drill},
      {"SPOT_DRILL", CatalogueShape::drill},
      {"INDEX_INSERT_DRILL", CatalogueShape::drill},
      {"GUN_DRILL", CatalogueShape::drill},
      {"CORE_DRILL_NON_INDEXABLE", CatalogueShape::drill},
      {"CORE_DRILL_INDEXABLE", CatalogueShape::drill},
      {"UG_DRILL", CatalogueShape::drill},
      {"COUNTER_SINKING", CatalogueShape::chamfer},
      {"COUNTER_BORE", CatalogueShape::flat},
      {"T_SLOT_MILL_NON_INDEXABLE", CatalogueShape::slot},
      {"SPHERICAL_MILL_NON_INDEXABLE", CatalogueShape::lollipop},
      {"THREAD_MILL", CatalogueShape::full},
      {"TAP", CatalogueShape::full},
      {"CHUCKING_REAMER", CatalogueShape::flat}};
  for (const auto& [name, shape] : kClasses)
    if (name == tool_class) return shape;
  return std::nullopt;
}

std::optional<Dimension> dimension_of(const std::string& field, CatalogueShape shape) {
  if (field == "DIA") return Dimension::diameter;
  if (field == "FLEN") return Dimension::flute_length;
  if (field == "COR1") return Dimension::corner_radius;
  if (field == "TAPA") return Dimension::taper_angle;
  if (field == "TIPA" || field == "PANG")
    return shape == CatalogueShape::drill || shape == CatalogueShape::chamfer ? Dimension::point_angle
                                                                              : Dimension::bottom_angle;
  if (field == "COR2" && shape == CatalogueShape::slot) return Dimension::upper_radius;
  if (field == "TSDIA" && shape == CatalogueShape::lollipop) return Dimension::shank_diameter;
  return catalogue_dimension(field);
}

class RowImporter {
 public:
  RowImporter(Collector& collector, const NxRow& row, LengthUnit unit, NxHolderSource& holders)
      : collector_(collector), row_(row), unit_(unit), holders_(holders) {
    tool_.line = row.line;
    tool_.unit = unit;
    tool_.name = text("LIBRF");
    if (const std::optional<long long> number = parse_integer(text("TLNUM")); number && *number > 0)
      tool_.number = tool_number(*number);
    collector.count(tool_.number, tool_.name);
    if (!tool_.number && tool_.name.empty()) tool_.name = "row in line " + std::to_string(row.line);
    who_ = tool_label(tool_.number, tool_.name);
  }

  void read() {
    const std::optional<CatalogueShape> shape = nx_shape(row_.class_name);
    if (!shape) return collector_.leave_out(who_, row_.class_name, row_.line);
    tool_.shape = *shape;
    if (const Outcome good = read_dimensions(); !good) return collector_.report(who_, good.error(), row_.line);
    if (const Outcome good = read_lengths(); !good) return collector_.report(who_, good.error(), row_.line);
    read_holder(text("HLDREF"));
    collector_.add(std::move(tool_));
  }

 private:
  [[nodiscard]] std::string text(const std::string& field) const { return row_.text(field); }

  // Returns a number of the row; nothing for an empty field.
  Result<std::optional<double>> number(const std::string& field, bool angle) const {
    return row_.number(field, angle ? 1 : mm_per(unit_));
  }

  Outcome read_dimensions() {
    for (const auto& [field, value] : row_.values) {
      const std::optional<Dimension> dimension = dimension_of(field, tool_.shape);
      if (!dimension) continue;
      const Result<std::optional<double>> read = number(field, is_angle(*dimension));
      if (!read) return read.error();
      if (*read) tool_.dimensions.set(*dimension, **read, field);
    }
    // A countersink is given by the angle of the whole point.
    if (const std::optional<Given>& point = tool_.dimensions[Dimension::point_angle];
        point && tool_.shape == CatalogueShape::chamfer)
      tool_.dimensions.set(Dimension::taper_angle, point->value / 2, "half of " + point->key);
    return Done{};
  }

  // Reads the lengths. HEI is the length of the tool up to its shank. The shank stands on it. HOFF is the length within
  // the holder.
  Outcome read_lengths() {
    double values[5] = {};
    const char* fields[5] = {"HEI", "TSDIA", "TSLEN", "TSTLEN", "HOFF"};
    for (int i = 0; i < 5; ++i) {
      const Result<std::optional<double>> read = number(fields[i], false);
      if (!read) return read.error();
      values[i] = read->value_or(0);
      if (values[i] < 0)
        return make_error("import-field", std::string(fields[i]) + " " + mm_text(values[i]) +
                                              " is not possible; it must not be negative");
    }
    const auto [height, shank_diameter, shank_length, taper_length, offset] = values;
    if (!(height > 0)) return Done{};
    constexpr double kWrittenDigit_mm = 1e-4;
    Dimensions& d = tool_.dimensions;
    if (d.value_or(Dimension::flute_length, 0) > height + kWrittenDigit_mm)
      return make_error("import-field", d.text(Dimension::flute_length) + " is greater than HEI " + mm_text(height) +
                                            "; the flutes cannot be longer than the tool");
    d.set(Dimension::shoulder_length, height, "HEI");
    const bool has_shank = shank_diameter > 0 && shank_length > 0;
    d.set(Dimension::overall_length, height + (has_shank ? shank_length : 0), has_shank ? "HEI + TSLEN" : "HEI");
    if (has_shank) {
      add_shank(shank_diameter, shank_length, std::min(taper_length, shank_length));
      collector_.report(
          who_,
          make_note("import-guess", "the shank of TSDIA " + mm_text(shank_diameter) + " and TSLEN " +
                                        mm_text(shank_length) + " is taken to stand on HEI " + mm_text(height)),
          row_.line);
    }
    if (offset > 0)
      d.set(Dimension::body_length, d[Dimension::overall_length]->value - offset,
            "length below the holder (" + d[Dimension::overall_length]->key + " - HOFF)");
    return Done{};
  }

  // Adds the holder if the stick-out of the tool is known.
  void read_holder(const std::string& name) {
    if (name.empty() || name == "0") return;
    const auto left_out = [&](const std::string& why) {
      tool_.missing_holder = "its holder \"" + name + "\" " + why;
      collector_.report(who_, make_warning("import-left-out", tool_.missing_holder), row_.line);
    };
    const std::vector<ToolSegment>* segments = holders_.called(name);
    if (segments == nullptr)
      return left_out(
          "stands in another file (holder_database.dat) and was left out; put that file beside this one, or "
          "give a holder with --holder");
    const bool has_stickout =
        tool_.dimensions.value_or(Dimension::body_length, 0) > 0 || collector_.options().stickout_mm;
    if (!has_stickout)
      return left_out("was left out, as HOFF does not say how much of the tool is in it; give --stickout");
    tool_.holder = *segments;
  }

  void add_shank(double diameter_mm, double length_mm, double taper_mm) {
    const double below_mm = tool_.dimensions.value_or(Dimension::diameter, diameter_mm);
    if (taper_mm > 0 && below_mm > 0) tool_.shaft.push_back({below_mm, diameter_mm, taper_mm});
    if (length_mm > taper_mm) tool_.shaft.push_back({diameter_mm, diameter_mm, length_mm - taper_mm});
  }

  Collector& collector_;
  const NxRow& row_;
  LengthUnit unit_;
  NxHolderSource& holders_;
  CatalogueTool tool_;
  std::string who_;
};

Result<LengthUnit> unit_of(const std::string& file, const ImportOptions& options) {
  if (options.unit) return *options.unit;
  const auto has_folder = [&](const std::string& name) {
    return file.find("/" + name + "/") != std::string::npos || file.starts_with(name + "/");
  };
  if (has_folder("metric")) return LengthUnit::mm;
  if (has_folder("english")) return LengthUnit::inch;
  return make_error("import-unit",
                    "this format does not say its unit, and the file is in no folder named metric or english; give "
                    "--unit mm or --unit inch",
                    file);
}

}  // namespace

Result<ImportedTools> import_nx(const std::string& file, std::string_view bytes, const ImportOptions& options) {
  Collector collector(file, options);
  NxDatabaseReader reader(collector);
  const std::vector<NxRow> rows = reader.read(bytes);
  if (!reader.has_class() && !has_holders(rows))
    return make_error("import-format",
                      "there is no #CLASS in this file; expected an NX tool_database.dat or holder_database.dat", file);
  const Result<LengthUnit> unit = unit_of(file, options);
  if (!unit) return unit.error();
  if (!options.unit)
    collector.report(
        "the library",
        make_note("import-guess", std::string("lengths are taken in ") + (*unit == LengthUnit::mm ? "mm" : "inches") +
                                      ", after the folder the file is in"),
        0);
  if (has_holders(rows)) {
    import_nx_holders(collector, rows, *unit);
    return collector.finish();
  }
  NxHolderSource holders(options, *unit);
  for (const NxRow& row : rows) RowImporter(collector, row, *unit, holders).read();
  return collector.finish();
}

}  // namespace gouge

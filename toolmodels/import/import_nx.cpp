#include <algorithm>
#include <map>
#include <utility>

#include "lib/base/number_text.h"
#include "toolmodels/import/collector.h"
#include "toolmodels/import/import_tools.h"
#include "toolmodels/import/quantity.h"

namespace gouge {
namespace {

using Fields = std::vector<std::string>;

struct Row {
  std::string tool_class;
  std::map<std::string, std::string> values;
  std::size_t line = 0;
};

std::optional<CatalogueShape> shape_of(const std::string& tool_class) {
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

Fields split_blanks(std::string_view text) {
  Fields words;
  for (text = trim_blanks(text); !text.empty(); text = trim_blanks(text)) {
    const std::size_t end = std::min(text.find_first_of(" \t"), text.size());
    words.emplace_back(text.substr(0, end));
    text.remove_prefix(end);
  }
  return words;
}

// The bar that closes a row is no empty last field.
Fields split_bars(std::string_view text) {
  Fields fields;
  text = trim_blanks(text);
  if (!text.empty() && text.front() == '|') text.remove_prefix(1);
  while (true) {
    const std::size_t bar = text.find('|');
    fields.push_back(clean_text(text.substr(0, bar)));
    if (bar == std::string_view::npos) break;
    text.remove_prefix(bar + 1);
    if (trim_blanks(text).empty()) break;
  }
  return fields;
}

bool begins_with_word(std::string_view line, std::string_view word) {
  return line.starts_with(word) && (line.size() == word.size() || line[word.size()] == ' ' ||
                                    line[word.size()] == '\t' || line[word.size()] == '|');
}

class DatabaseReader {
 public:
  DatabaseReader(Collector& collector) : collector_(collector) {}

  /// A row may go on in lines that begin with a bar, a FORMAT in lines without a keyword.
  std::vector<Row> read(std::string_view text) {
    for (std::size_t line = 1; !text.empty(); ++line) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      take(trim_blanks(text.substr(0, end)), line);
      text.remove_prefix(std::min(end + 1, text.size()));
    }
    close_row();
    return std::move(rows_);
  }

  [[nodiscard]] bool has_class() const { return has_class_; }

 private:
  void take(std::string_view line, std::size_t number) {
    if (line.empty()) return;
    if (line.front() == '#') {
      close_row();
      is_in_format_ = false;
      const bool is_class = begins_with_word(line, "#CLASS");
      if (!is_class && !begins_with_word(line, "#END_DATA")) return;
      class_ = is_class ? clean_text(line.substr(6)) : std::string();
      has_class_ = has_class_ || is_class;
      format_.clear();
    } else if (begins_with_word(line, "FORMAT")) {
      close_row();
      format_ = split_blanks(line.substr(6));
      is_in_format_ = true;
    } else if (begins_with_word(line, "DATA")) {
      close_row();
      is_in_format_ = false;
      data_ = std::string(line.substr(4));
      data_line_ = number;
    } else if (line.front() == '|' && data_line_ > 0) {
      data_ += line;
    } else if (is_in_format_) {
      for (std::string& word : split_blanks(line)) format_.push_back(std::move(word));
    }
  }

  void close_row() {
    if (data_line_ == 0) return;
    const Fields fields = split_bars(data_);
    const std::size_t line = std::exchange(data_line_, 0);
    if (class_.empty() || format_.empty())
      return collector_.report("row", make_error("import-field", "a DATA row stands outside of a #CLASS with a FORMAT"),
                               line);
    if (fields.size() > format_.size())
      return collector_.report(
          "row \"" + fields.front() + "\"",
          make_error("import-field", "has " + std::to_string(fields.size()) + " values, but its FORMAT names " +
                                         std::to_string(format_.size()) + " fields"),
          line);
    Row row{class_, {}, line};
    for (std::size_t i = 0; i < fields.size(); ++i) row.values.emplace(format_[i], fields[i]);
    rows_.push_back(std::move(row));
  }

  Collector& collector_;
  std::vector<Row> rows_;
  std::string class_, data_;
  Fields format_;
  std::size_t data_line_ = 0;
  bool is_in_format_ = false, has_class_ = false;
};

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
  RowImporter(Collector& collector, const Row& row, LengthUnit unit) : collector_(collector), row_(row), unit_(unit) {
    tool_.line = row.line;
    tool_.unit = unit;
    tool_.name = text("LIBRF");
    if (const std::optional<long long> number = parse_integer(text("TLNUM")); number && *number > 0)
      tool_.number = tool_number(*number);
    if (!tool_.number && tool_.name.empty()) tool_.name = "row in line " + std::to_string(row.line);
    who_ = tool_label(tool_.number, tool_.name);
  }

  void read() {
    const std::optional<CatalogueShape> shape = shape_of(row_.tool_class);
    if (!shape) return collector_.leave_out(who_, row_.tool_class, row_.line);
    tool_.shape = *shape;
    if (const Outcome good = read_dimensions(); !good) return collector_.report(who_, good.error(), row_.line);
    if (const Outcome good = read_lengths(); !good) return collector_.report(who_, good.error(), row_.line);
    if (!text("HLDREF").empty() && text("HLDREF") != "0")
      collector_.report(
          who_,
          make_warning("import-left-out",
                       "its holder \"" + text("HLDREF") +
                           "\" stands in another file (holder_database.dat) and was left out; give one with --holder"),
          row_.line);
    collector_.add(std::move(tool_));
  }

 private:
  [[nodiscard]] std::string text(const std::string& field) const {
    const auto found = row_.values.find(field);
    return found == row_.values.end() ? std::string() : found->second;
  }

  // Nothing for an empty field.
  Result<std::optional<double>> number(const std::string& field, bool angle) const {
    const std::string value = text(field);
    if (value.empty()) return std::optional<double>();
    const std::optional<Quantity> quantity = parse_quantity(value);
    if (!quantity || quantity->unit != QuantityUnit::none)
      return make_error("import-field", field + " is \"" + value + "\"; expected a number");
    return std::optional<double>(angle ? quantity->value : quantity->value * mm_per(unit_));
  }

  Outcome read_dimensions() {
    for (const auto& [field, value] : row_.values) {
      const std::optional<Dimension> dimension = dimension_of(field, tool_.shape);
      if (!dimension) continue;
      const Result<std::optional<double>> read = number(field, is_angle(*dimension));
      if (!read) return read.error();
      if (*read) tool_.dimensions.set(*dimension, **read, field);
    }
    // A countersink has its angle as that of the whole point.
    if (const std::optional<Given>& point = tool_.dimensions[Dimension::point_angle];
        point && tool_.shape == CatalogueShape::chamfer)
      tool_.dimensions.set(Dimension::taper_angle, point->value / 2, "half of " + point->key);
    return Done{};
  }

  // HEI is the tool's length up to its shank, the shank stands on it, and HOFF of the whole is in the holder.
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
    Dimensions& d = tool_.dimensions;
    if (d.value_or(Dimension::flute_length, 0) > height + 1e-4)
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

  void add_shank(double diameter_mm, double length_mm, double taper_mm) {
    const double below_mm = tool_.dimensions.value_or(Dimension::diameter, diameter_mm);
    if (taper_mm > 0 && below_mm > 0) tool_.shaft.push_back({below_mm, diameter_mm, taper_mm});
    if (length_mm > taper_mm) tool_.shaft.push_back({diameter_mm, diameter_mm, length_mm - taper_mm});
  }

  Collector& collector_;
  const Row& row_;
  LengthUnit unit_;
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
  DatabaseReader reader(collector);
  const std::vector<Row> rows = reader.read(bytes);
  if (!reader.has_class())
    return make_error("import-format", "there is no #CLASS in this file; expected an NX tool_database.dat", file);
  const Result<LengthUnit> unit = unit_of(file, options);
  if (!unit) return unit.error();
  if (!options.unit)
    collector.report(
        "the library",
        make_note("import-guess", std::string("lengths are taken in ") + (*unit == LengthUnit::mm ? "mm" : "inches") +
                                      ", after the folder the file is in"),
        0);
  for (const Row& row : rows) RowImporter(collector, row, *unit).read();
  return collector.finish();
}

}  // namespace gouge

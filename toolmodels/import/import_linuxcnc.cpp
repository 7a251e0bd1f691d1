#include <algorithm>

#include "lib/base/letters.h"
#include "lib/base/number_text.h"
#include "toolmodels/import/collector.h"
#include "toolmodels/import/import_tools.h"

// LinuxCNC: a line for each tool, "T1 P1 D6.0 Z+52.3 ;6 mm end mill". Source: LinuxCNC, Tool Compensation, tool table.

namespace gouge {
namespace {

std::string_view without_remark(std::string_view line) { return trim_blanks(line.substr(0, line.find(';'))); }

bool is_row(std::string_view line) {
  return line.size() > 1 && capital(line[0]) == 'T' && (is_digit(line[1]) || line[1] == '-' || line[1] == '+');
}

/// Calls `take` with the number, the words and the remark of each line that is not empty.
template <typename Take>
void for_each_row(std::string_view text, Take take) {
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end), words = without_remark(line);
    const std::size_t remark = std::min(line.find(';'), line.size());
    if (!words.empty()) take(number, words, trim_blanks(line.substr(std::min(remark + 1, line.size()))));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

/// Returns the text behind a letter: "6.0" of "D6.0"; nothing if no word begins with it.
std::optional<std::string_view> text_behind(std::string_view words, char letter) {
  for (std::size_t at = 0; at < words.size();) {
    const std::size_t end = std::min(words.find_first_of(" \t\r", at), words.size());
    const std::string_view word = words.substr(at, end - at);
    at = std::min(end + 1, words.size());
    if (word.size() > 1 && capital(word[0]) == letter) return word.substr(1);
  }
  return std::nullopt;
}

/// Returns the number behind a letter. Error: import-field, there is none, or it is not above 0.
Result<double> length_behind(std::string_view words, char letter, const char* what) {
  const auto text = text_behind(words, letter);
  const auto number = text ? parse_number(text->substr(text->starts_with('+') ? 1 : 0)) : std::nullopt;
  const std::string name(1, letter);
  if (text && !number)
    return make_error("import-field", name + ", its " + what + ", is '" + clean_text(std::string(*text)) +
                                          "'; expected a number" +
                                          (text->find(',') != text->npos ? " with a decimal point" : ""));
  if (!number || !(*number > 0)) return make_error("import-field", "has no " + name + ", its " + what + ", above 0");
  return *number;
}

void read_row(std::string_view words, std::string_view remark, std::size_t line, const ImportOptions& options,
              Collector& collector) {
  const LengthUnit unit = options.unit.value_or(LengthUnit::mm);
  CatalogueTool tool;
  tool.line = line;
  tool.unit = unit;
  tool.name = clean_text(std::string(remark));
  const std::string number(text_behind(words, 'T').value_or(std::string_view()));
  const auto whole = parse_integer(number);
  if (whole) tool.number = tool_number(*whole);
  collector.count(tool.number, tool.name);
  const std::string who = tool_label(tool.number, tool.name);
  if (!tool.number)
    return collector.report(who,
                            make_error("import-field", "its number is '" + clean_text(number) +
                                                           "'; expected a whole "
                                                           "number from 0"),
                            line);
  const Result<double> diameter = length_behind(words, 'D', "diameter");
  if (!diameter) return collector.report(who, diameter.error(), line);
  const Result<double> length = length_behind(words, 'Z', "length");
  if (!length) return collector.report(who, length.error(), line);
  // Z ends at the gauge point of the spindle, so a stick-out that is stated counts instead.
  const double body_mm = std::min(*length * mm_per(unit), options.stickout_mm.value_or(*length * mm_per(unit)));
  tool.shape = CatalogueShape::flat;
  tool.dimensions.set(Dimension::diameter, *diameter * mm_per(unit), "D");
  tool.dimensions.set(Dimension::flute_length, body_mm, "Z");
  if (!options.stickout_mm) tool.dimensions.set(Dimension::body_length, body_mm, "Z");
  tool.uncertainty =
      "the tool table of LinuxCNC states D and Z alone; the tool is taken as a cylinder of this diameter, and "
      "its lengths in " +
      std::string(unit == LengthUnit::inch ? "inches" : unit_name(unit));
  collector.add(std::move(tool));
}

}  // namespace

bool is_linuxcnc_table(std::string_view text) {
  bool is_table = false;
  bool has_others = false;
  for_each_row(text, [&](std::size_t, std::string_view words, std::string_view) {
    const bool is_one =
        is_row(words) && text_behind(words, 'P') && (text_behind(words, 'D') || text_behind(words, 'Z'));
    is_table = is_table || is_one;
    has_others = has_others || !is_one;
  });
  return is_table && !has_others;
}

Result<ImportedTools> import_linuxcnc(const std::string& file, std::string_view bytes, const ImportOptions& options) {
  Collector collector(file, options);
  for_each_row(bytes, [&](std::size_t line, std::string_view words, std::string_view remark) {
    read_row(words, remark, line, options, collector);
  });
  return collector.finish();
}

}  // namespace gouge

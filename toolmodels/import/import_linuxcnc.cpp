#include <algorithm>

#include "lib/base/letters.h"
#include "lib/base/number_text.h"
#include "toolmodels/import/collector.h"
#include "toolmodels/import/import_tools.h"

// LinuxCNC: a line for each tool, "T1 P1 D6.0 Z+52.3 ;6 mm end mill". Source: LinuxCNC, Tool Compensation, tool table.

namespace gouge {
namespace {

std::string_view without_remark(std::string_view line) { return trim_blanks(line.substr(0, line.find(';'))); }

bool is_row(std::string_view line) { return line.size() > 1 && capital(line[0]) == 'T' && is_digit(line[1]); }

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

/// Returns the number behind a letter: "D6.0"; nothing if there is none.
std::optional<double> value_of(std::string_view words, char letter) {
  for (std::size_t at = 0; at < words.size();) {
    const std::size_t end = std::min(words.find_first_of(" \t\r", at), words.size());
    const std::string_view word = words.substr(at, end - at);
    at = std::min(end + 1, words.size());
    if (word.size() < 2 || capital(word[0]) != letter) continue;
    return parse_number(word.substr(word[1] == '+' ? 2 : 1));
  }
  return std::nullopt;
}

void read_row(std::string_view words, std::string_view remark, std::size_t line, LengthUnit unit,
              Collector& collector) {
  CatalogueTool tool;
  tool.line = line;
  tool.unit = unit;
  tool.name = clean_text(std::string(remark));
  if (const auto number = value_of(words, 'T')) tool.number = tool_number(static_cast<long long>(*number));
  const std::string who = tool_label(tool.number, tool.name);
  const double diameter = value_of(words, 'D').value_or(0), length = value_of(words, 'Z').value_or(0);
  if (!(diameter > 0))
    return collector.report(who, make_error("import-field", "has no D, its diameter, above 0"), line);
  if (!(length > 0)) return collector.report(who, make_error("import-field", "has no Z, its length, above 0"), line);
  tool.shape = CatalogueShape::flat;
  tool.dimensions.set(Dimension::diameter, diameter * mm_per(unit), "D");
  tool.dimensions.set(Dimension::flute_length, length * mm_per(unit), "Z");
  tool.dimensions.set(Dimension::body_length, length * mm_per(unit), "Z");
  tool.uncertainty =
      "the tool table of LinuxCNC states D and Z alone; the tool is taken as a cylinder of this diameter, and "
      "its lengths in " +
      std::string(unit_name(unit));
  collector.add(std::move(tool));
}

}  // namespace

bool is_linuxcnc_table(std::string_view text) {
  bool is_table = false;
  bool has_others = false;
  for_each_row(text, [&](std::size_t, std::string_view words, std::string_view) {
    const bool is_one = is_row(words) && value_of(words, 'P') && (value_of(words, 'D') || value_of(words, 'Z'));
    is_table = is_table || is_one;
    has_others = has_others || !is_one;
  });
  return is_table && !has_others;
}

Result<ImportedTools> import_linuxcnc(const std::string& file, std::string_view bytes, const ImportOptions& options) {
  Collector collector(file, options);
  const LengthUnit unit = options.unit.value_or(LengthUnit::mm);
  for_each_row(bytes, [&](std::size_t line, std::string_view words, std::string_view remark) {
    read_row(words, remark, line, unit, collector);
  });
  return collector.finish();
}

}  // namespace gouge

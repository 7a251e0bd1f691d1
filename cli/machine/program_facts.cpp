#include "cli/machine/program_facts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "cli/values/parse_lengths.h"
#include "lib/base/file_kind.h"
#include "lib/base/letters.h"
#include "lib/base/number_text.h"
#include "postproc/gcode/heidenhain/tool_table.h"

namespace gouge {
namespace {

std::optional<Vec3> parse_point(const std::vector<std::string>& parts, std::size_t first) {
  Vec3 point;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto length = parse_length_mm(parts[first + i]);
    if (!length) return std::nullopt;
    point[static_cast<int>(i)] = *length;
  }
  return point;
}

std::optional<std::pair<std::string, WorkOffset>> parse_offset(const std::string& text) {
  const std::size_t equal = text.find('=');
  if (equal == std::string::npos || equal == 0) return std::nullopt;
  const std::string name = in_capitals(text.substr(0, equal));
  if (name[0] != 'G' && !name.starts_with("PRESET")) return std::nullopt;
  const std::vector<std::string> parts = split_text(text.substr(equal + 1), ',');
  if (parts.size() != 3 && parts.size() != 6) return std::nullopt;
  WorkOffset offset;
  const auto point = parse_point(parts, 0);
  if (!point) return std::nullopt;
  offset.xyz_mm = *point;
  for (std::size_t i = 3; i < parts.size(); ++i) {
    const auto angle = parse_number(parts[i]);
    if (!angle) return std::nullopt;
    offset.abc_deg[static_cast<int>(i) - 3] = *angle;
  }
  return std::pair{name, offset};
}

/// A row of a table of tools.
struct ToolRow {
  int tool = 0;
  double length_mm = 0;
  double diameter_mm = 0;  ///< 0: not stated
};

/// Returns a row of CSV; none: it is of another form.
std::optional<ToolRow> parse_csv_row(std::string_view line) {
  const std::vector<std::string> parts = split_text(std::string(line), ',');
  if (parts.size() != 2) return std::nullopt;
  const auto tool = parse_integer(trim_blanks(parts[0]));
  const auto length = parse_number(trim_blanks(parts[1]));
  if (!tool || *tool < 0 || *tool > 1'000'000 || !length) return std::nullopt;
  return ToolRow{static_cast<int>(*tool), *length};
}

/// Returns a row of a tool table of LinuxCNC; none: it is of another form.
std::optional<ToolRow> parse_table_row(std::string_view line) {
  std::optional<long long> tool;
  double length = 0, diameter = 0;
  bool is_sideways = false;
  for (const std::string& word : split_text(std::string(line), ' ')) {
    if (word.empty()) continue;
    const char letter = capital(word[0]);
    std::string_view value = std::string_view(word).substr(1);
    if (value.starts_with('+')) value.remove_prefix(1);
    if (letter == 'T') tool = parse_integer(value);
    if (std::string_view("XYZABCUVWD").find(letter) == std::string_view::npos) continue;
    const auto number = parse_number(value);
    if (!number) return std::nullopt;
    if (letter == 'Z')
      length = *number;
    else if (letter == 'D')
      diameter = std::max(*number, 0.0);
    else
      is_sideways = is_sideways || std::abs(*number) > 0;
  }
  if (!tool || *tool < 0 || *tool > 1'000'000) return std::nullopt;
  return ToolRow{static_cast<int>(*tool), is_sideways ? kSidewaysLength : length, diameter};
}

Diagnostic wrong_value(const std::string& option, const std::string& typed, const std::string& expected) {
  return make_error("usage", option + " '" + typed + "': expected " + expected);
}

/// A word of an option, and its values.
struct WordOption {
  const std::string &option, &typed;
  std::vector<std::string> values;
};

/// Returns the error of a word that is none of the values; an empty one is not stated.
std::optional<Diagnostic> find_wrong_word(const WordOption& word) {
  if (word.typed.empty() || std::ranges::find(word.values, word.typed) != word.values.end()) return std::nullopt;
  return wrong_value(word.option, word.typed, listed(word.values, " or "));
}

constexpr std::array<std::pair<const char*, TipFrame>, 4> kTipFrames{{{"table", TipFrame::table},
                                                                      {"table-at-zero", TipFrame::table_at_zero},
                                                                      {"table-at-call", TipFrame::table_at_call},
                                                                      {"workpiece", TipFrame::workpiece}}};

std::vector<std::string> tip_frame_names() {
  std::vector<std::string> names;
  for (const auto& [name, frame] : kTipFrames) names.emplace_back(name);
  return names;
}

}  // namespace

Result<ProgramSetup> understand_program(const StatedProgram& stated, const ProgramOptionNames& names) {
  for (const WordOption& word : {WordOption{names.block_delete, stated.block_delete, {"on", "off"}},
                                 {names.plain_numbers, stated.plain_numbers, {"units", "increments"}},
                                 {names.rotary_turns, stated.rotary_turns, {"as-programmed"}},
                                 {names.tip_frame, stated.tip_frame, tip_frame_names()}}) {
    if (auto wrong = find_wrong_word(word)) return std::move(*wrong);
  }
  ProgramSetup setup;
  setup.control = stated.control;
  setup.is_control_stated = !stated.control.empty();
  for (const std::string& text : stated.offsets) {
    const auto offset = parse_offset(text);
    if (!offset) return wrong_value(names.offset, text, "a work offset such as G54=x,y,z or G54=x,y,z,a,b,c");
    if (!setup.offsets.insert(*offset).second) return wrong_value(names.offset, text, "each work offset once");
  }
  for (const std::string& block : stated.start) setup.start += block + "\n";
  for (const std::string& code : stated.tip_control_ends) setup.tip_control_ends.push_back(in_capitals(code));
  if (!stated.block_delete.empty()) setup.is_block_delete_on = stated.block_delete == "on";
  if (!stated.home.empty()) {
    const std::vector<std::string> parts = split_text(stated.home, ',');
    if (parts.size() == 3) setup.home_mm = parse_point(parts, 0);
    if (!setup.home_mm) return wrong_value(names.home, stated.home, "three lengths x,y,z");
  }
  if (stated.plain_numbers == "units") setup.plain_numbers = PlainNumbers::units;
  if (stated.plain_numbers == "increments") setup.plain_numbers = PlainNumbers::increments;
  if (!stated.rotary_turns.empty()) setup.winds_as_programmed = true;
  for (const auto& [name, frame] : kTipFrames)
    if (stated.tip_frame == name) setup.tip_frame = frame;
  return setup;
}

Result<ToolTable> parse_tool_lengths(const std::string& file, std::string_view text) {
  text = without_byte_order_mark(text);
  if (is_heidenhain_tool_table(text)) return read_heidenhain_tool_table(file, text);
  ToolTable table;
  table.file = file;
  std::optional<bool> is_csv;
  std::size_t number = 0;
  while (!text.empty()) {
    ++number;
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    line = trim_blanks(line.substr(0, line.find(';')));
    if (line.empty()) continue;
    if (!is_csv) {
      std::string heading(line);
      std::erase(heading, ' ');
      is_csv = in_capitals(heading) == "TOOL,LENGTH";
      if (*is_csv) continue;
    }
    const auto row = *is_csv ? parse_csv_row(line) : parse_table_row(line);
    if (!row)
      return make_error(
          "tool-lengths",
          "'" + std::string(line.substr(0, 40)) +
              "' is no row of lengths; expected CSV with the heading tool,length, or rows such as T1 Z120",
          file, number);
    if (row->diameter_mm > 0) table.diameters_mm[row->tool] = row->diameter_mm;
    if (!table.lengths_mm.emplace(row->tool, row->length_mm).second)
      return make_error("tool-lengths", "tool " + std::to_string(row->tool) + " occurs twice; expected each tool once",
                        file, number);
  }
  if (table.lengths_mm.empty()) return make_error("tool-lengths", "holds no length of a tool", file);
  return table;
}

void take_tool_table(ToolTable table, ProgramSetup& setup) {
  setup.tool_table = std::move(table.file);
  setup.lengths_mm = std::move(table.lengths_mm);
  setup.diameters_mm = std::move(table.diameters_mm);
  setup.corners_mm = std::move(table.corners_mm);
}

}  // namespace gouge

#include "postproc/gcode/heidenhain/tool_table.h"

#include <algorithm>
#include <optional>

#include "lib/base/number_text.h"
#include "lib/base/units.h"

namespace gouge {
namespace {

constexpr std::string_view kBegin = "BEGIN TOOL", kExtension = ".T", kEnd = "[END]";
constexpr int kMaxTool = 32'767;  // input range of T

std::string_view take_line(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

/// A column: from the first letter of its heading to that of the next one.
struct Column {
  std::size_t begin = std::string_view::npos, end = std::string_view::npos;

  [[nodiscard]] bool is_there() const { return begin != std::string_view::npos; }
  [[nodiscard]] std::string_view of(std::string_view row) const {
    if (!is_there() || begin >= row.size()) return {};
    return trim_blanks(row.substr(begin, end - begin));
  }
};

Column find_column(std::string_view heading, std::string_view name) {
  for (std::size_t at = 0; at < heading.size();) {
    const std::size_t begin = heading.find_first_not_of(" \t", at);
    if (begin == std::string_view::npos) break;
    const std::size_t end = std::min(heading.find_first_of(" \t", begin), heading.size());
    if (heading.substr(begin, end - begin) == name) return {begin, heading.find_first_not_of(" \t", end)};
    at = end;
  }
  return {};
}

/// Returns the value that runs across the beginning of a column; empty: none does.
std::string_view value_across(std::string_view row, std::size_t border) {
  const auto is_filled = [&](std::size_t at) { return at < row.size() && row[at] != ' ' && row[at] != '\t'; };
  if (border == 0 || !is_filled(border - 1) || !is_filled(border)) return {};
  const std::size_t begin = row.find_last_of(" \t", border) + 1;
  return row.substr(begin, row.find_first_of(" \t", border) - begin);
}

/// Returns the value of a cell; 0 where it is empty. None: it is no number.
std::optional<double> cell_value(std::string_view cell) {
  if (cell.empty()) return 0;
  return parse_number(cell);
}

class TableReader {
 public:
  TableReader(const std::string& file, std::string_view text) : file_(file), text_(text) { table_.file = file; }

  Result<ToolTable> read() {
    const std::string_view begin = next();
    mm_ = begin.find(" MM") != std::string_view::npos     ? 1
          : begin.find(" INCH") != std::string_view::npos ? mm_per(LengthUnit::inch)
                                                          : 0;
    if (mm_ <= 0) return wrong("the table states neither MM nor INCH");
    const std::string_view heading = next();
    tool_ = find_column(heading, "T");
    length_ = find_column(heading, "L");
    delta_ = find_column(heading, "DL");
    radius_ = find_column(heading, "R");
    radius_delta_ = find_column(heading, "DR");
    corner_ = find_column(heading, "R2");
    corner_delta_ = find_column(heading, "DR2");
    if (!tool_.is_there() || !length_.is_there()) return wrong("the heading of the table has no T or no L");
    while (!text_.empty()) {
      const std::string_view row = next();
      if (trim_blanks(row) == kEnd) return table_;
      if (trim_blanks(row).empty()) continue;
      if (const std::string reason = take(row); !reason.empty()) return wrong(reason);
    }
    return wrong("the table has no [END]: rows may be missing");
  }

 private:
  std::string_view next() {
    ++line_;
    return take_line(text_);
  }
  [[nodiscard]] Diagnostic wrong(const std::string& reason) const {
    return make_error("tool-lengths", reason, file_, line_);
  }

  /// Returns the reason why the values of a row do not stand in their columns; empty: they do.
  [[nodiscard]] std::string why_misaligned(std::string_view row) const {
    for (const Column* column : {&tool_, &length_, &delta_, &radius_, &radius_delta_, &corner_, &corner_delta_}) {
      if (!column->is_there()) continue;
      for (const std::size_t border : {column->begin, column->end})
        if (const std::string_view value = value_across(row, border); !value.empty())
          return "'" + std::string(value.substr(0, 40)) +
                 "' stands in two columns of the table; expected each value below the word of its heading";
    }
    return {};
  }

  std::string take(std::string_view row) {
    if (std::string reason = why_misaligned(row); !reason.empty()) return reason;
    const std::string_view number = tool_.of(row), length = length_.of(row);
    const bool is_index = number.find('.') != std::string_view::npos;
    if (is_index || length.empty()) return {};  // a further length of a tool, or a place without one
    const auto tool = parse_integer(number);
    const auto stated = cell_value(length), delta = cell_value(delta_.of(row));
    const auto radius = cell_value(radius_.of(row)), radius_delta = cell_value(radius_delta_.of(row));
    const auto corner = cell_value(corner_.of(row)), corner_delta = cell_value(corner_delta_.of(row));
    if (!tool || *tool < 0 || *tool > kMaxTool || !stated || !delta || !radius || !radius_delta || !corner ||
        !corner_delta)
      return "'" + std::string(row.substr(0, 40)) +
             "' is no row of the table; expected numbers below T, L, R, R2, DL, DR and DR2";
    const int id = static_cast<int>(*tool);
    const bool is_first = table_.lengths_mm.emplace(id, (*stated + *delta) * mm_).second;
    if (*radius > 0) table_.diameters_mm[id] = 2 * (*radius + *radius_delta) * mm_;
    // Where R and R2 are 0, the cutter is not filled in.
    const double corner_sum = *corner + *corner_delta;
    if (!corner_.of(row).empty() && (*radius > 0 || corner_sum > 0))
      table_.corners_mm[id] = std::max(corner_sum, 0.0) * mm_;
    return is_first ? "" : "tool " + std::to_string(*tool) + " occurs twice; expected each tool once";
  }

  const std::string& file_;
  std::string_view text_;
  std::size_t line_ = 0;
  double mm_ = 1;
  Column tool_, length_, delta_, radius_, radius_delta_, corner_, corner_delta_;
  ToolTable table_;
};

}  // namespace

bool is_heidenhain_tool_table(std::string_view text) {
  const std::string_view line = take_line(text);
  if (!line.starts_with(kBegin)) return false;
  return trim_blanks(line.substr(kBegin.size())).starts_with(kExtension);
}

Result<ToolTable> read_heidenhain_tool_table(const std::string& file, std::string_view text) {
  return TableReader(file, text).read();
}

}  // namespace gouge

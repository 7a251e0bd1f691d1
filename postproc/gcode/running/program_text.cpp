#include "postproc/gcode/running/program_text.h"

#include <algorithm>

#include "lib/base/file_kind.h"
#include "lib/base/letters.h"
#include "lib/base/number_text.h"

namespace gouge {
namespace {

bool is_percent(std::string_view line) { return !line.empty() && line.front() == '%'; }

/// Returns whether a line begins with this letter and number.
bool has_label(std::string_view line, char letter, int number) {
  line = trim_blanks(line);
  if (line.starts_with('/')) line = trim_blanks(line.substr(1));
  if (line.empty() || capital(line[0]) != letter) return false;
  line = trim_blanks(line.substr(1));
  const auto digits = static_cast<std::size_t>(std::ranges::find_if_not(line, is_digit) - line.begin());
  const auto stated = parse_integer(line.substr(0, digits));
  return stated && *stated == number;
}

}  // namespace

void add_lines(std::string_view text, SourceStatements& lines) {
  std::size_t number = 0;
  const std::size_t begin = text.size() - without_byte_order_mark(text).size();
  for (std::size_t at = begin; at < text.size();) {
    const std::size_t found = text.find('\n', at);
    const std::size_t next = found == std::string_view::npos ? text.size() : found + 1;
    ++number;
    const std::string_view line = text.substr(at, next - at);
    if (line.find_first_not_of(" \t\r\n") != std::string_view::npos) {
      if (lines.size() == lines.capacity()) lines.reserve(lines.size() + lines.size() / 2 + 1024);
      lines.push_back({number, at, next});
    }
    at = next;
  }
}

ProgramText::ProgramText(std::string_view text, const SourceStatements& lines)
    : text_(text), lines_(lines), end_(lines.size()) {
  std::size_t percents = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!is_percent(trim_blanks(line(i)))) continue;
    if (++percents == 1) begin_ = i + 1;
    if (percents == 2) {
      end_ = i;
      break;
    }
  }
  // One percent sign in the last line ends a program that begins without one.
  if (percents == 1 && begin_ == lines.size()) {
    begin_ = 0;
    end_ = lines.size() - 1;
  }
}

StoredProgram::StoredProgram(std::string bytes)
    : bytes_(std::move(bytes)),
      lines_([this] {
        SourceStatements lines;
        add_lines(bytes_, lines);
        return lines;
      }()),
      text_(bytes_, lines_) {}

std::string_view ProgramText::line(std::size_t index) const {
  const SourceStatement& one = lines_[index];
  std::string_view line = text_.substr(one.first_byte, one.last_byte - one.first_byte);
  while (!line.empty() && (line.back() == '\n' || line.back() == '\r')) line.remove_suffix(1);
  return line;
}

std::optional<std::size_t> ProgramText::find_label(char letter, int number, std::size_t from, std::size_t until,
                                                   bool is_unique) const {
  std::optional<std::size_t> found;
  for (std::size_t i = from; i < until; ++i) {
    if (!has_label(line(i), letter, number)) continue;
    if (!is_unique) return i;
    if (found) return std::nullopt;
    found = i;
  }
  return found;
}

std::string in_line(std::size_t line) {
  return line == 0 ? " in the blocks at the start (--start)" : " in line " + std::to_string(line);
}

}  // namespace gouge

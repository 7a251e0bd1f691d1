#include "postproc/cldata/reading/foreign_file.h"

#include <cstddef>

#include "lib/base/file_kind.h"
#include "lib/base/number_text.h"
#include "postproc/cldata/language/text.h"

namespace gouge {
namespace {

constexpr std::size_t kForeignLines = 300;
constexpr std::size_t kStlHeader = 80, kStlCount = 4, kStlTriangle = 50;

constexpr const char* kProgram =
    "looks like a program for a machine's control; expected CL data, or --dialect gcode and --control with the control";
constexpr const char* kColumns =
    "holds columns of numbers without words, so what they mean is not stated; expected GOTO/x,y,z,i,j,k";

constexpr const char* kColumnsUnderHeading =
    "holds columns of numbers under a heading, and what they mean is not stated; expected GOTO/x,y,z,i,j,k";

bool is_binary_stl(std::string_view bytes) {
  if (bytes.size() < kStlHeader + kStlCount) return false;
  std::size_t count = 0;
  for (std::size_t i = kStlCount; i-- > 0;) count = count * 256 + static_cast<unsigned char>(bytes[kStlHeader + i]);
  return count > 0 && bytes.size() == kStlHeader + kStlCount + kStlTriangle * count;
}

bool is_number_character(char c) { return is_digit(c) || c == '.' || c == '-' || c == '+'; }

// Returns whether a line is G-code, with letters that are each followed by a number: "N10 G1 X1.5 Y-2 F200", "%",
// "O1234", "G0X1Y2", "G1 X  1.5".
bool is_gcode_block(std::string_view line) {
  if (line == "%") return true;
  std::size_t words = 0;
  for (std::size_t i = 0; i < line.size();) {
    if (is_blank(line[i]) || line[i] == '/') {
      ++i;
      continue;
    }
    if (line[i] == '(' || line[i] == ';') return words > 0;
    std::size_t number = i + 1;
    while (number < line.size() && is_blank(line[number])) ++number;
    if (!is_letter(line[i]) || number >= line.size() || !is_number_character(line[number])) return false;
    for (i = number; i < line.size() && is_number_character(line[i]);) ++i;
    ++words;
  }
  return words > 0;
}

// Returns whether a line is one of the macro language of Fanuc and its relatives: "#120=#24", "IF[#1EQ#0]GOTO5",
// "WHILE[#1LT5]DO1", "END1".
bool is_macro_line(std::string_view line) {
  if (line.size() > 1 && line[0] == '#') return is_digit(line[1]) || line[1] == '[';
  for (const std::string_view word : {"IF[", "IF [", "WHILE[", "WHILE ["})
    if (starts_with_ignoring_case(line, word)) return true;
  return line.size() == 4 && starts_with_ignoring_case(line, "END") && is_digit(line[3]);
}

bool is_comment(std::string_view line) { return line.front() == '(' || line.front() == ';'; }

// Returns whether a line has only numbers, at least three, separated by blanks, commas or semicolons.
bool is_row_of_numbers(std::string_view line) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < line.size();) {
    if (is_blank(line[i]) || line[i] == ',' || line[i] == ';') {
      ++i;
      continue;
    }
    std::size_t end = i;
    while (end < line.size() && !is_blank(line[end]) && line[end] != ',' && line[end] != ';') ++end;
    if (!parse_number(line.substr(i, end - i))) return false;
    ++count;
    i = end;
  }
  return count >= 3;
}

std::optional<std::string> describe_lines(std::string_view bytes) {
  constexpr std::size_t kLongestHeading = 5;
  std::size_t blocks = 0, rows = 0, others = 0, heading = 0;
  bool is_first = true;
  for (std::size_t at = 0, lines = 0; at < bytes.size() && lines < kForeignLines; ++lines) {
    const std::size_t end = bytes.find('\n', at);
    const std::string_view line = trim(bytes.substr(at, end - at));
    at = end == std::string_view::npos ? bytes.size() : end + 1;
    if (line.empty()) continue;
    if (is_first && starts_with_ignoring_case(line, "solid") && bytes.find("facet") != std::string_view::npos)
      return "is an STL mesh; expected a toolpath (a check takes the mesh with --part)";
    const bool is_program =
        starts_with_ignoring_case(line, "BEGIN PGM") || line.find(" BEGIN PGM ") != std::string_view::npos;
    if (is_first && is_program) return kProgram;
    is_first = false;
    if (is_comment(line)) continue;
    if (is_gcode_block(line) || is_macro_line(line)) {
      ++blocks;
    } else if (is_row_of_numbers(line)) {
      ++rows;
    } else {
      // A statement of CL data cannot be the heading of its own continuation.
      const bool may_head =
          rows + blocks == 0 && heading < kLongestHeading && line.find_first_of("/$") == std::string_view::npos;
      ++(may_head ? heading : others);
    }
  }
  others += rows > 0 ? 0 : heading;
  if (blocks > 2 && blocks > 4 * (others + rows)) return kProgram;
  if (rows > 0 && others + blocks == 0) return heading == 0 ? kColumns : kColumnsUnderHeading;
  return std::nullopt;
}

std::string advice_for(const FileKind& kind) {
  switch (kind.family) {
    case FileFamily::solid:
      return ", which holds geometry and no toolpath";
    case FileFamily::mesh:
      return "; expected a toolpath in its place";
    case FileFamily::archive:
      return "; unpack it and check the toolpath in it";
    case FileFamily::text:
      return ", not CL data";
    case FileFamily::document:
      break;
    case FileFamily::stand_in:
      return "; " + std::string(kind.advice);
  }
  return "; expected a toolpath";
}

}  // namespace

std::optional<std::string> describe_foreign(std::string_view name, std::string_view bytes) {
  if (is_binary_stl(bytes)) return "is an STL mesh; expected a toolpath (a check takes the mesh with --part)";
  const std::optional<FileKind> kind = recognise_file(name, bytes);
  return kind ? "is " + std::string(kind->name) + advice_for(*kind) : describe_lines(bytes);
}

}  // namespace gouge

#include "tests/laws/loose_statements.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>

namespace gouge::laws {
namespace {

constexpr std::array<std::string_view, 6> kTextWords{"PPRINT", "PARTNO", "REMARK", "INSERT", "TPRINT", "LETTER"};
// A name follows them, which no `$` continues.
constexpr std::array<std::string_view, 5> kNamingWords{"TOOLPATH", "CSI_TOOL_PATH", "OPFEATSTART", "OPFEATEND",
                                                       "OPNAME"};

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

std::string upper(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return result;
}

// `N10 GOTO`, `20 CUTTER`, `LAB1) GOTO`: what stands before the word.
std::string_view without_label(std::string_view text) {
  std::size_t i = 0;
  if (!text.empty() && (text[0] == 'N' || text[0] == 'n')) i = 1;
  const std::size_t digits = i;
  while (i < text.size() && is_digit(text[i])) ++i;
  if (i > digits) {
    while (i < text.size() && is_blank(text[i])) ++i;
    if (i < text.size() && is_letter(text[i])) return text.substr(i);
  }
  i = 0;
  while (i < text.size() && (is_letter(text[i]) || is_digit(text[i]))) ++i;
  return i > 0 && i < text.size() && text[i] == ')' ? trimmed(text.substr(i + 1)) : text;
}

void part(LooseStatement& statement, const std::string& joined) {
  statement.whole = upper(without_label(trimmed(joined)));
  const std::size_t slash = statement.whole.find('/');
  statement.word = squeezed(statement.whole.substr(0, slash));
  if (slash != std::string::npos) statement.rest = statement.whole.substr(slash + 1);
  while (!statement.rest.empty() && statement.rest.front() == '/') statement.rest.erase(0, 1);  // `GOTO//1,2,3`
  statement.arguments = loose_arguments(statement.rest);
}

}  // namespace

std::string squeezed(std::string_view text) {
  std::string result;
  for (const char c : upper(text)) {
    if (!is_blank(c)) result += c;
  }
  return result;
}

std::optional<double> loose_number(std::string_view text) {
  std::string number(text);
  std::size_t i = 0, digits = 0;
  if (i < number.size() && (number[i] == '+' || number[i] == '-')) ++i;
  bool has_point = false;
  for (; i < number.size() && (is_digit(number[i]) || (number[i] == '.' && !has_point)); ++i) {
    if (number[i] == '.')
      has_point = true;
    else
      ++digits;
  }
  if (digits == 0) return std::nullopt;
  if (i < number.size() && (number[i] == 'E' || (number[i] == 'D' && has_point))) {
    number[i++] = 'E';
    if (i < number.size() && (number[i] == '+' || number[i] == '-')) ++i;
    const std::size_t exponent = i;
    while (i < number.size() && is_digit(number[i])) ++i;
    if (i == exponent) return std::nullopt;
  }
  if (i < number.size()) return std::nullopt;
  return std::strtod(number.c_str(), nullptr);
}

std::vector<LooseArgument> loose_arguments(std::string_view text) {
  std::vector<LooseArgument> arguments;
  if (trimmed(text).empty()) return arguments;
  std::size_t begin = 0;
  while (begin <= text.size()) {
    const std::size_t comma = std::min(text.find(',', begin), text.size());
    std::string_view piece = trimmed(text.substr(begin, comma - begin));
    const bool is_quoted = !piece.empty() && piece.front() == '\'';
    do {  // blanks part arguments as well
      const std::size_t end = is_quoted ? piece.size() : std::min(piece.find_first_of(" \t"), piece.size());
      arguments.push_back({upper(piece.substr(0, end)), loose_number(upper(piece.substr(0, end)))});
      piece = trimmed(piece.substr(end));
    } while (!piece.empty());
    begin = comma + 1;
  }
  return arguments;
}

std::vector<std::string_view> physical_lines(std::string_view bytes) {
  std::vector<std::string_view> lines;
  std::size_t begin = 0;
  while (begin < bytes.size()) {
    const std::size_t end = std::min(bytes.find('\n', begin), bytes.size());
    lines.push_back(trimmed(bytes.substr(begin, end - begin)));
    begin = end + 1;
  }
  return lines;
}

std::vector<LooseStatement> loose_statements(std::string_view bytes) {
  const std::vector<std::string_view> lines = physical_lines(bytes);
  std::vector<LooseStatement> statements;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].empty()) continue;
    LooseStatement statement;
    statement.line = i + 1;
    const bool is_creo_data = lines[i].starts_with("$$->");
    const std::string start = squeezed(lines[i].substr(0, 15));
    if (lines[i].starts_with("$$") && !is_creo_data) {
      statement.is_comment = true;
      statement.rest = upper(lines[i].substr(2));
    } else if (std::any_of(kTextWords.begin(), kTextWords.end(),
                           [&](std::string_view word) { return start.starts_with(word); })) {
      statement.is_text = true;
      statement.word = start.substr(0, 6);
      statement.rest = upper(lines[i]);
    } else {
      const bool is_naming = std::any_of(kNamingWords.begin(), kNamingWords.end(),
                                         [&](std::string_view word) { return start.starts_with(word); });
      std::string joined(is_creo_data ? "$$->" : "");
      std::string_view piece = is_creo_data ? lines[i].substr(4) : lines[i];
      while (true) {
        piece = piece.substr(0, piece.find("$$"));
        std::size_t dollar = is_naming ? std::string_view::npos : piece.find('$');
        // A name may hold a dollar.
        if (is_creo_data) dollar = piece.ends_with('$') ? piece.size() - 1 : std::string_view::npos;
        joined += std::string(piece.substr(0, dollar)) + " ";
        if (dollar == std::string_view::npos) break;
        if (i + 1 >= lines.size()) {
          statement.is_cut_off = true;
          break;
        }
        piece = lines[++i];
        // A comment in between is text, but where it is data and starts what comes next.
        if (piece.starts_with("$$*") || piece.starts_with("$$->")) statement.is_cut_off = true;
        while (i + 1 < lines.size() && (piece.empty() || piece.starts_with("$$")) && !statement.is_cut_off) {
          piece = lines[++i];
          if (piece.starts_with("$$*") || piece.starts_with("$$->")) statement.is_cut_off = true;
        }
        if (statement.is_cut_off) break;
      }
      part(statement, joined);
    }
    statement.last_line = i + 1;
    statements.push_back(std::move(statement));
  }
  return statements;
}

}  // namespace gouge::laws

#include "postproc/gcode/heidenhain/plain_statements.h"

#include <algorithm>
#include <array>
#include <set>
#include <vector>

#include "lib/base/letters.h"
#include "lib/base/number_text.h"
#include "postproc/gcode/heidenhain/klartext_block.h"
#include "postproc/gcode/heidenhain/klartext_words.h"

namespace gouge {
namespace {

using Kind = KlartextWord::Kind;
using Words = std::vector<KlartextWord>;

/// A form of BLK FORM: the words behind its first ones, each at most once.
struct BlankForm {
  std::string_view keywords;
  bool has_axis = false;          ///< the axis of the tool follows: Z
  std::string_view numbers = {};  ///< names of words with a number, between blanks; a step I counts as the same word
  std::string_view names = {};    ///< names of words without a number, between blanks
  std::string_view texts = {};    ///< names of words with a text, between blanks
};

constexpr std::array<BlankForm, 5> kBlankForms = {{
    {.keywords = "0.1", .has_axis = true, .numbers = " X Y Z "},
    {.keywords = "0.2", .numbers = " X Y Z "},
    {.keywords = "CYLINDER", .has_axis = true, .numbers = " R D L DIST RI DI "},
    {.keywords = "ROTATION", .has_axis = true, .numbers = " LBL ", .names = " DIM_R DIM_D ", .texts = " LBL "},
    {.keywords = "FILE", .texts = " FILE TARGET "},
}};

bool is_listed(std::string_view names, std::string_view name) {
  return names.find(" " + std::string(name) + " ") != std::string_view::npos;
}

bool has_form(const BlankForm& form, const Words& words) {
  std::set<std::string> seen;
  const std::size_t first = form.has_axis ? 1 : 0;
  const bool begins_well =
      !form.has_axis || (!words.empty() && words[0].kind == Kind::name && is_listed(" X Y Z ", words[0].name));
  if (!begins_well) return false;
  return std::all_of(words.begin() + static_cast<std::ptrdiff_t>(first), words.end(), [&](const KlartextWord& word) {
    const bool is_step = word.name.size() == 2 && word.name[0] == 'I' && is_listed(" X Y Z ", word.name.substr(1));
    const std::string name = is_step ? word.name.substr(1) : word.name;
    const std::string_view names = word.kind == Kind::number ? form.numbers
                                   : word.kind == Kind::text ? form.texts
                                   : word.kind == Kind::name ? form.names
                                                             : std::string_view();
    return is_listed(names, name) && seen.insert(name).second;
  });
}

bool is_blank_form(std::string_view text, const QParameters& parameters) {
  for (const BlankForm& form : kBlankForms) {
    const bool is_here = text.starts_with(form.keywords);
    if (!is_here) continue;
    // FILE is a word of its own text: FILE "BLANK.STL".
    std::string_view rest = form.keywords == "FILE" ? text : text.substr(form.keywords.size());
    const bool is_apart = rest.empty() || !is_capital(rest[0]) || form.keywords == "FILE";
    Words words;
    return is_apart && read_klartext_words(rest, parameters, words).empty() && has_form(form, words);
  }
  return false;
}

/// Returns whether a text is a number or a parameter.
bool is_operand(std::string_view text, const QParameters& parameters) {
  return read_operand(trim_blanks(text), parameters).error.empty();
}

std::vector<std::string_view> parts_of(std::string_view text, char mark) {
  std::vector<std::string_view> parts;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(mark, at), text.size());
    parts.push_back(trim_blanks(text.substr(at, end - at)));
    at = end + 1;
  }
  return parts;
}

/// A file, or a device such as SCREEN:, without blanks or between quotation marks.
bool is_file(std::string_view text) {
  if (text.size() > 1 && text.starts_with('"')) return text.find('"', 1) == text.size() - 1;
  return !text.empty() && text.find_first_of(" \t\"") == std::string_view::npos;
}

bool is_error(std::string_view text, const QParameters& parameters) {
  if (!take_keywords(text, "ERROR")) return false;
  if (text.starts_with('=')) text.remove_prefix(1);
  return is_operand(text, parameters);
}

bool is_print(std::string_view text, const QParameters& parameters) {
  if (!take_keywords(text, "PRINT")) return false;
  const std::vector<std::string_view> parts = parts_of(text, '/');
  const bool is_list = std::ranges::all_of(parts, [&](std::string_view one) { return is_operand(one, parameters); });
  return is_list || (parts.size() == 1 && is_file(parts[0]));
}

bool is_formatted_print(std::string_view text, const QParameters&) {
  if (!take_keywords(text, "F-PRINT")) return false;
  const std::vector<std::string_view> parts = parts_of(text, '/');
  return parts.size() == 2 && is_file(parts[0]) && is_file(parts[1]);
}

// WAIT FOR SYNC, WAIT FOR I32==+1
bool is_wait(std::string_view text, const QParameters& parameters) {
  if (!take_keywords(text, "WAIT FOR")) return false;
  if (text == "SYNC") return true;
  static constexpr std::array<std::string_view, 6> kComparisons = {"==", "<>", "<=", ">=", "<", ">"};
  const bool begins_well = text.size() > 1 && is_capital(text[0]) && is_digit(text[1]);
  if (!begins_well) return false;
  text.remove_prefix(1);
  while (!text.empty() && is_digit(text[0])) text.remove_prefix(1);
  text = trim_blanks(text);
  for (const std::string_view one : kComparisons)
    if (text.starts_with(one)) return is_operand(text.substr(one.size()), parameters);
  return false;
}

// SEND /"Q1: %F" / +Q1
bool is_send(std::string_view text, const QParameters& parameters) {
  if (!take_keywords(text, "SEND") || !text.starts_with('/')) return false;
  text = trim_blanks(text.substr(1));
  const std::size_t close = text.starts_with('"') ? text.find('"', 1) : std::string_view::npos;
  if (close == std::string_view::npos) return false;
  text = trim_blanks(text.substr(close + 1));
  if (text.empty()) return true;
  const std::vector<std::string_view> parts = parts_of(text, '/');
  return parts[0].empty() && parts.size() > 1 &&
         std::all_of(parts.begin() + 1, parts.end(), [&](std::string_view one) { return is_operand(one, parameters); });
}

struct PlainFunction {
  std::string_view number;
  bool (*is_form)(std::string_view text, const QParameters& parameters);
};

constexpr std::array<PlainFunction, 5> kPlainFunctions = {{
    {"14", is_error},
    {"15", is_print},
    {"16", is_formatted_print},
    {"20", is_wait},
    {"38", is_send},
}};

std::string not_read(std::string_view name, std::string_view text) {
  return std::string(name) + " '" + std::string(text.substr(0, 30)) +
         "' has no form that is read; expected the words of its form alone";
}

}  // namespace

std::optional<std::string> read_plain_statement(std::string_view text, const QParameters& parameters) {
  if (take_keywords(text, "BLK FORM"))
    return is_blank_form(text, parameters) ? std::string() : not_read("BLK FORM", text);
  if (!take_keywords(text, "FN")) return std::nullopt;
  for (const PlainFunction& one : kPlainFunctions) {
    std::string_view rest = text;
    if (!take_keywords(rest, one.number)) continue;
    const bool is_read = rest.starts_with(':') && one.is_form(trim_blanks(rest.substr(1)), parameters);
    return is_read ? std::string() : not_read("FN " + std::string(one.number), rest);
  }
  return std::nullopt;
}

bool is_pair_of_operands(std::string_view text, std::string_view word, const QParameters& parameters) {
  const std::size_t at = text.find(word);
  return at != std::string_view::npos && is_operand(text.substr(0, at), parameters) &&
         is_operand(text.substr(at + word.size()), parameters);
}

bool is_value_of_control(std::string_view text, const QParameters& parameters) {
  Words words;
  if (!read_klartext_words(text, parameters, words).empty() || words.empty() || !words[0].has_number("ID"))
    return false;
  std::set<std::string> seen;
  return std::ranges::all_of(words, [&](const KlartextWord& word) {
    return word.kind == Kind::number && is_listed(" ID NR IDX ", word.name) && seen.insert(word.name).second;
  });
}

}  // namespace gouge

#include "postproc/gcode/siemens/siemens_lexer.h"

#include <algorithm>
#include <array>

#include "lib/base/letters.h"
#include "lib/base/number_text.h"
#include "postproc/gcode/siemens/siemens_expression.h"

namespace gouge {
namespace {

constexpr auto kFlowWords = std::to_array<std::string_view>(
    {"IF",      "ELSE",  "ENDIF", "WHILE",   "ENDWHILE", "FOR",     "ENDFOR", "LOOP",  "ENDLOOP", "REPEAT",
     "REPEATB", "UNTIL", "GOTO",  "GOTOF",   "GOTOB",    "GOTOC",   "GOTOS",  "CASE",  "DEF",     "PROC",
     "EXTERN",  "RET",   "CALL",  "EXTCALL", "PCALL",    "ISOCALL", "DEFINE", "REDEF", "DEFAULT"});

bool begins_number(char c) { return is_digit(c) || c == '.' || c == '-' || c == '+'; }

class SiemensLexer {
 public:
  SiemensLexer(std::string_view text, const SiemensVariables& variables, SiemensBlock& block)
      : c_{text}, variables_(variables), block_(block) {}

  void run() {
    while (c_.error.empty()) {
      c_.skip_blanks();
      if (c_.is_end()) break;
      read_word();
    }
    if (block_.error.empty()) block_.error = std::move(c_.error);
  }

 private:
  [[nodiscard]] char at(std::size_t ahead) const {
    return c_.at + ahead < c_.text.size() ? capital(c_.text[c_.at + ahead]) : '\0';
  }

  void read_word() {
    const char first = at(0);
    if (!is_capital(first) && first != '_' && first != '$') return c_.fail_at_character();
    if (is_capital(first) && begins_number(at(1)) && !is_extended()) return read_address();
    read_named();
  }

  // An address with a number of its own: S1=1000, A3=0.5, R10=5.
  [[nodiscard]] bool is_extended() const {
    std::size_t ahead = 1;
    while (is_digit(at(ahead))) ++ahead;
    if (ahead == 1) return false;
    while (at(ahead) == ' ' || at(ahead) == '\t') ++ahead;
    return at(ahead) == '=' && at(ahead + 1) != '=';
  }

  void read_address() {
    const char address = at(0);
    SiemensWord& word = block_.words.emplace_back();
    word.name = address;
    word.form = SiemensWord::Form::number;
    ++c_.at;
    const std::size_t begin = c_.at;
    word.value = read_siemens_number(c_);
    if (address == 'L') word.text = std::string(trim_blanks(c_.text.substr(begin, c_.at - begin)));
    if (!c_.error.empty()) c_.error = word.name + ": " + c_.error;
    if (address != 'G' && address != 'M') return;
    constexpr double kMaxCode = 99999;
    const bool is_code = word.value >= 0 && word.value <= kMaxCode;
    if (!is_code) return c_.fail(word.name + " without the number of a code");
    const auto number = static_cast<int>(word.value);
    word.name += number < word.value ? exact_text(word.value) : std::to_string(number);
    word.form = SiemensWord::Form::alone;
  }

  void read_named() {
    const std::string name = read_siemens_name(c_);
    c_.skip_blanks();
    if (c_.peek() == '=' && at(1) != '=') {
      ++c_.at;
      return variables_.has(name) ? read_assignment(name) : read_value_of(name);
    }
    if (c_.peek() == '[') return c_.fail("'" + name + "[' is not read");
    SiemensWord& word = block_.words.emplace_back();
    word.name = name;
    if (c_.peek() == '(') {
      word.form = SiemensWord::Form::call;
      ++c_.at;
      read_arguments(word);
    }
  }

  void read_assignment(const std::string& name) {
    const bool uses_earlier = !block_.assignments.empty();
    const std::size_t begin = c_.at;
    const double value = read_siemens_value(c_, variables_);
    // Whether a value that the block sets already counts is not stated.
    const std::string used(c_.text.substr(begin, c_.at - begin));
    const bool is_number =
        std::ranges::none_of(used, [](char c) { return is_capital(capital(c)) || c == '_' || c == '$'; });
    block_.assignments.push_back({name, uses_earlier && !is_number ? kUnknownValue : value});
  }

  void read_value_of(const std::string& name) {
    SiemensWord word;
    word.name = name;
    word.form = SiemensWord::Form::number;
    c_.skip_blanks();
    if (c_.peek() == '"') {
      word.text = read_string();
      if (c_.error.empty() && word.text.empty()) c_.fail(name + " has an empty text");
      block_.words.push_back(std::move(word));
      return;
    }
    word.measure = read_measure();
    if (word.measure != SiemensMeasure::modal) ++c_.at;
    word.value = read_siemens_value(c_, variables_);
    if (word.measure != SiemensMeasure::modal && c_.error.empty()) {
      c_.skip_blanks();
      if (c_.peek() != ')') c_.fail(name + " has a measure without its closing bracket");
      ++c_.at;
    }
    if (!c_.error.empty()) c_.error = name + ": " + c_.error;
    block_.words.push_back(std::move(word));
  }

  // Leaves the cursor at the bracket behind the measure.
  SiemensMeasure read_measure() {
    const std::size_t begin = c_.at;
    const std::string name = read_siemens_name(c_);
    c_.skip_blanks();
    if (c_.peek() == '(') {
      if (name == "AC") return SiemensMeasure::absolute;
      if (name == "IC") return SiemensMeasure::incremental;
      if (name == "DC") return SiemensMeasure::shortest;
      if (name == "ACP") return SiemensMeasure::positive;
      if (name == "ACN") return SiemensMeasure::negative;
    }
    c_.at = begin;
    return SiemensMeasure::modal;
  }

  std::string read_string() {
    const std::size_t close = c_.text.find('"', c_.at + 1);
    if (close == std::string_view::npos) {
      c_.fail("a text without its closing quotation mark");
      return {};
    }
    std::string text(c_.text.substr(c_.at + 1, close - c_.at - 1));
    c_.at = close + 1;
    return text;
  }

  void read_arguments(SiemensWord& word) {
    c_.skip_blanks();
    if (c_.peek() == ')') {
      ++c_.at;
      return;
    }
    while (c_.error.empty()) {
      const std::size_t begin = c_.at;
      word.arguments.push_back(read_argument());
      note_variables(c_.text.substr(begin, std::min(c_.at, c_.text.size()) - begin), word);
      c_.skip_blanks();
      const char c = c_.peek();
      if (c == ')' || c == ',') ++c_.at;
      if (c == ')') return;
      if (c != ',') c_.fail("the arguments of " + word.name + " are not read");
    }
  }

  // Notes the variables of an argument, and "R" for R[..].
  void note_variables(std::string_view argument, SiemensWord& word) const {
    if (argument.find('"') != std::string_view::npos) return;
    while (!argument.empty()) {
      const std::size_t length = siemens_name_length(argument);
      const std::string name = in_capitals(argument.substr(0, length));
      if (name == "R" || variables_.has(name)) word.variables.push_back(SiemensVariables::one_spelling(name));
      argument.remove_prefix(std::max<std::size_t>(length, 1));
    }
  }

  SiemensArgument read_argument() {
    SiemensArgument made;
    c_.skip_blanks();
    const char c = c_.peek();
    if (c == ',' || c == ')') return made;
    made.is_empty = false;
    if (c == '"') {
      made.text = read_string();
      made.is_empty = made.text.empty();
      return made;
    }
    const std::size_t begin = c_.at;
    const std::string name = read_siemens_name(c_);
    c_.skip_blanks();
    const bool ends = c_.peek() == ',' || c_.peek() == ')';
    if (!name.empty() && ends && !variables_.has(name) && name != "TRUE" && name != "FALSE" && name[0] != '$') {
      made.text = name;
      return made;
    }
    c_.at = begin;
    made.value = read_siemens_value(c_, variables_);
    return made;
  }

  GcodeCursor c_;
  const SiemensVariables& variables_;
  SiemensBlock& block_;
};

std::string flow_word_at(std::string_view line, std::size_t at) {
  GcodeCursor c{line, at};
  c.skip_blanks();
  const bool may_be_word =
      c.at + 1 < line.size() && is_capital(capital(line[c.at])) && is_capital(capital(line[c.at + 1]));
  if (!may_be_word) return {};
  std::string name = read_siemens_name(c);
  if (std::ranges::find(kFlowWords, name) == kFlowWords.end()) name.clear();
  return name;
}

}  // namespace

std::string_view without_comment(std::string_view line) {
  if (line.find(';') == std::string_view::npos) return line;
  bool is_in_text = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"') is_in_text = !is_in_text;
    if (line[i] == ';' && !is_in_text) return line.substr(0, i);
  }
  return line;
}

SiemensLineStart read_siemens_start(std::string_view line) {
  SiemensLineStart start;
  GcodeCursor c{line};
  c.skip_blanks();
  if (c.peek() == '/') {
    start.is_skippable = true;
    ++c.at;
    if (is_digit(c.peek())) ++c.at;
    c.skip_blanks();
  }
  const auto digit_at = [&](std::size_t at) { return at < line.size() && is_digit(line[at]); };
  const bool is_numbered = (capital(c.peek()) == 'N' || c.peek() == ':') && digit_at(c.at + 1);
  if (is_numbered) {
    const std::size_t first = ++c.at;
    while (is_digit(c.peek())) ++c.at;
    start.number = line.substr(first, c.at - first);
    c.skip_blanks();
  }
  start.first_word = c.at;
  const std::size_t length = siemens_name_length(line.substr(std::min(c.at, line.size())));
  if (length > 1 && c.at + length < line.size() && line[c.at + length] == ':') {
    start.label = in_capitals(line.substr(c.at, length));
    start.first_word += length + 1;
  }
  return start;
}

std::string flow_word_of(std::string_view line) { return flow_word_at(line, read_siemens_start(line).first_word); }

void read_siemens_block(std::string_view line, const SiemensVariables& variables, SiemensBlock& block) {
  block.clear();
  const std::string_view text = without_comment(line);
  if (trim_blanks(text).starts_with('%')) return;  // the name of the program
  const SiemensLineStart start = read_siemens_start(text);
  block.is_skippable = start.is_skippable;
  block.flow_word = flow_word_at(text, start.first_word);
  const std::string_view words = text.substr(start.first_word);
  if (!block.flow_word.empty()) {
    block.flow_rest = trim_blanks(words);
    block.flow_rest.remove_prefix(block.flow_word.size());
    return;
  }
  SiemensLexer(words, variables, block).run();
}

}  // namespace gouge

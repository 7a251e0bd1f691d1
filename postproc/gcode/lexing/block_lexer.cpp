#include "postproc/gcode/lexing/block_lexer.h"

#include <algorithm>
#include <array>

#include "lib/base/letters.h"
#include "lib/base/number_text.h"
#include "postproc/gcode/lexing/expression.h"

namespace gouge {
namespace {

class BlockLexer {
 public:
  BlockLexer(std::string_view line, const GcodeSyntax& syntax, const GcodeVariables& variables, GcodeBlock& block)
      : c_{line}, syntax_(syntax), variables_(variables), block_(block) {}

  void run() {
    read_start();
    while (c_.error.empty()) {
      c_.skip_blanks();
      if (c_.is_end() || begins_flow()) break;
      read_part();
    }
    block_.error = std::move(c_.error);
  }

 private:
  // The mark for block delete, with or without the number of its switch, and the number of the block.
  void read_start() {
    c_.skip_blanks();
    if (c_.peek() == '/') {
      block_.is_skippable = true;
      ++c_.at;
      if (c_.peek() >= '1' && c_.peek() <= '9') ++c_.at;
      c_.skip_blanks();
    }
    if (capital(c_.peek()) != 'N') return;
    ++c_.at;
    c_.skip_blanks();
    const std::size_t begin = c_.at;
    while (c_.peek() >= '0' && c_.peek() <= '9') ++c_.at;
    block_.number = parse_integer(c_.text.substr(begin, c_.at - begin));
    if (!block_.number) c_.fail("N without the number of the block");
  }

  bool begins_flow() {
    const char first = capital(c_.peek());
    const bool is_o_word = syntax_.has_o_words && first == 'O';
    const char second = c_.at + 1 < c_.text.size() ? c_.text[c_.at + 1] : '\0';
    if (!is_o_word && !(is_letter(first) && is_letter(second))) return false;
    if (!is_o_word && !syntax_.has_macros) {
      c_.fail("'" + std::string(c_.text.substr(c_.at, 8)) + "' is no word of a letter and a number");
      return true;
    }
    block_.flow = c_.text.substr(c_.at);
    c_.at = c_.text.size();
    return true;
  }

  void read_part() {
    const char c = c_.peek();
    if (c == '(') return read_comment();
    if (c == ';') return read_after_semicolon();
    if (c == '#') return read_assignment();
    if (is_letter(c)) return read_word();
    c_.fail_at_character();
  }

  void read_comment() {
    const std::size_t close = c_.text.find(')', c_.at);
    if (close == std::string_view::npos) return c_.fail("a comment without its closing bracket");
    const std::string_view inner = c_.text.substr(c_.at + 1, close - c_.at - 1);
    if (inner.find('(') != std::string_view::npos && !syntax_.has_macros) return c_.fail("a comment within a comment");
    take_comment(inner);
    c_.at = std::max(c_.at, close + 1);
  }

  void read_after_semicolon() {
    const std::string_view rest = trim_blanks(c_.text.substr(c_.at + 1));
    if (syntax_.has_semicolon_comments)
      take_comment(rest);
    else if (!rest.empty())
      return c_.fail("text after the end of the block, which a semicolon is on this control");
    c_.at = c_.text.size();
  }

  // Source: LinuxCNC, Remap, "Executing arbitrary Python": such comments are statements.
  void take_comment(std::string_view text) {
    block_.comment = text;
    if (!syntax_.has_o_words) return;
    const std::string name = in_small_letters(trim_blanks(text.substr(0, std::min(text.find(','), text.size()))));
    if (name == "py" || name == "pyrun" || name == "pyreload") c_.fail("a comment that runs a statement of Python");
  }

  void read_assignment() {
    ++c_.at;
    GcodeAssignment made;
    made.variable = read_variable_name(c_, syntax_, variables_);
    c_.skip_blanks();
    if (c_.error.empty() && c_.peek() != '=') return c_.fail("a variable alone");
    ++c_.at;
    bool has_point = false;
    c_.is_rounded = false;
    const std::size_t begin = std::min(c_.at, c_.text.size());
    if (c_.error.empty())
      made.value = syntax_.has_macros ? read_expression(c_, syntax_, variables_)
                                      : read_value(c_, syntax_, variables_, has_point);
    made.is_rounded = c_.is_rounded;
    // No manual at hand states whether a value that the block sets already counts.
    const bool uses_variable = c_.text.substr(begin, c_.at - begin).find('#') != std::string_view::npos;
    if (syntax_.has_macros && uses_variable && !block_.assignments.empty()) made.value = kUnknownValue;
    block_.assignments.push_back(std::move(made));
  }

  void read_word() {
    GcodeWord& word = block_.words.emplace_back();
    word.letter = capital(c_.peek());
    word.first_byte = static_cast<std::uint32_t>(c_.at++);
    c_.is_address = true;
    word.value = read_value(c_, syntax_, variables_, word.has_point);
    c_.is_address = false;
    word.last_byte = static_cast<std::uint32_t>(c_.at);
    if (!c_.error.empty()) c_.error = std::string(1, word.letter) + ": " + c_.error;
  }

  GcodeCursor c_;
  const GcodeSyntax& syntax_;
  const GcodeVariables& variables_;
  GcodeBlock& block_;
};

}  // namespace

void read_gcode_block(std::string_view line, const GcodeSyntax& syntax, const GcodeVariables& variables,
                      GcodeBlock& block) {
  block.clear();
  BlockLexer(line, syntax, variables, block).run();
}

}  // namespace gouge

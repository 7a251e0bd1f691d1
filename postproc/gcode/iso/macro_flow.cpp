#include <algorithm>

#include "lib/base/letters.h"
#include "lib/base/number_text.h"
#include "postproc/gcode/iso/program_run.h"

// IF, WHILE and GOTO of Fanuc's custom macros, which Haas has too.
// Source: Fanuc B-64484EN, custom macro, branch and repetition.

namespace gouge {
namespace {

/// Takes a word in capitals from the beginning of a text; false: it does not begin with it.
bool take_word(std::string_view& text, std::string_view word) {
  std::string_view rest = trim_blanks(text);
  const bool is_here = rest.size() >= word.size() && std::equal(word.begin(), word.end(), rest.begin(),
                                                                [](char a, char b) { return a == capital(b); });
  if (is_here) text = rest.substr(word.size());
  return is_here;
}

/// Takes a whole number; none: the rest of the text is no number alone.
std::optional<int> take_last_number(std::string_view text) {
  text = trim_blanks(text.substr(0, text.find('(')));
  if (text.ends_with(';')) text = trim_blanks(text.substr(0, text.size() - 1));
  const auto number = parse_integer(text);
  constexpr long long kLargest = 99'999'999;
  return number && *number >= 0 && *number <= kLargest ? std::optional(static_cast<int>(*number)) : std::nullopt;
}

}  // namespace

void ProgramRun::run_macro(std::string_view flow) {
  const std::string shown(trim_blanks(flow));
  std::string_view text = flow;
  if (take_word(text, "GOTO")) {
    if (const auto number = take_last_number(text)) return go_to(*number);
  } else if (take_word(text, "IF")) {
    const auto holds = condition(text);
    if (!holds) return;
    if (take_word(text, "GOTO")) {
      const auto number = take_last_number(text);
      if (number && !*holds) return;
      if (number) return go_to(*number);
    } else if (take_word(text, "THEN")) {
      if (!*holds) return;
      GcodeBlock then;
      read_gcode_block(text, control_.syntax, variables_, then);
      if (then.error.empty() && then.words.empty() && then.flow.empty()) {
        lose_at_system_variable(then.assignments);
        return assign(then.assignments);
      }
    }
  } else if (take_word(text, "WHILE")) {
    const auto holds = condition(text);
    if (!holds) return;
    if (take_word(text, "DO")) {
      const auto number = take_last_number(text);
      if (number && *holds) return;
      if (number) return end_loop(*number);
    }
  } else if (take_word(text, "END")) {
    const auto number = take_last_number(text);
    if (number) {
      for (std::size_t i = at_; i-- > text_->begin();) {
        const std::string line = in_capitals(text_->line(i));
        const std::size_t loop = line.find("DO");
        if (loop == std::string::npos || line.find("WHILE") == std::string::npos) continue;
        if (take_last_number(std::string_view(line).substr(loop + 2)) != number) continue;
        next_ = i;
        return;
      }
    }
  }
  lose("'" + shown.substr(0, 40) + "' is not read");
}

// The block is looked for in the program that runs: from O to the next O.
std::optional<std::size_t> ProgramRun::find_block(int number) const {
  std::size_t begin = calls_.empty() ? text_->begin() : calls_.back().begin, end = text_->end();
  const auto is_name = [&](std::size_t i) {
    const std::string_view line = trim_blanks(text_->line(i));
    return !line.empty() && (line[0] == 'O' || line[0] == 'o');
  };
  for (std::size_t i = begin + 1; i < end; ++i) {
    if (!is_name(i)) continue;
    end = i;
    break;
  }
  return text_->find_label('N', number, begin, end, true);
}

void ProgramRun::go_to(int number) {
  const auto block = find_block(number);
  if (!block) return lose("no block, or more than one, has the number N" + std::to_string(number));
  next_ = *block;
}

void ProgramRun::end_loop(int number) {
  for (std::size_t i = at_ + 1; i < text_->end(); ++i) {
    std::string_view line = trim_blanks(text_->line(i));
    if (line.starts_with('N') || line.starts_with('n')) {
      line = line.substr(1);
      while (!line.empty() && (line[0] == ' ' || (line[0] >= '0' && line[0] <= '9'))) line = line.substr(1);
    }
    if (!take_word(line, "END") || take_last_number(line) != number) continue;
    next_ = i + 1;
    return;
  }
  lose("a loop has no END" + std::to_string(number));
}

}  // namespace gouge

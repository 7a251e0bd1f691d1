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

/// Returns a line without what stands in parentheses. Conditions have brackets.
std::string without_comments(std::string line) {
  for (std::size_t open = line.find('('); open != std::string::npos; open = line.find('(')) {
    const std::size_t close = line.find(')', open);
    line.erase(open, close == std::string::npos ? close : close - open + 1);
  }
  return line;
}

/// Takes a whole number; none: the rest of the text is no number alone.
std::optional<int> take_last_number(std::string_view text) {
  text = trim_blanks(text.substr(0, text.find('(')));
  if (text.ends_with(';')) text = trim_blanks(text.substr(0, text.size() - 1));
  const auto number = parse_integer(text);
  constexpr long long kLargest = 99'999'999;
  return number && *number >= 0 && *number <= kLargest ? std::optional(static_cast<int>(*number)) : std::nullopt;
}

char first_of(std::string_view line) {
  line = trim_blanks(line);
  return line.empty() ? '\0' : line[0];
}

std::string_view without_number(std::string_view line) {
  if (!line.starts_with('N')) return line;
  return trim_blanks(line.substr(std::min(line.find_first_not_of(" 0123456789", 1), line.size())));
}

/// WHILE with DO, or END, with the number of the loop.
struct LoopMark {
  bool is_end = false;
  std::optional<int> number;
  bool is_skippable = false;  ///< a slash stands before it: a switch of the control may leave it out
};

/// Returns the mark of a loop in a line; none: it has none.
std::optional<LoopMark> loop_mark_of(const std::string& line) {
  const std::string code = without_comments(in_capitals(line));
  std::string_view text = trim_blanks(code);
  LoopMark mark;
  text = without_number(text);
  if (text.starts_with('/')) {
    mark.is_skippable = true;
    text = without_number(trim_blanks(text.substr(std::min(text.find_first_not_of("/0123456789"), text.size()))));
  }
  mark.is_end = take_word(text, "END");
  if (!mark.is_end && !take_word(text, "WHILE")) return std::nullopt;
  if (!mark.is_end) {
    const std::size_t start = text.rfind("DO");
    if (start == std::string_view::npos) return std::nullopt;
    text = text.substr(start + 2);
  }
  mark.number = take_last_number(text);
  return mark;
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
    if (const std::string& fault = loops_of_macro().fault(); !fault.empty()) return lose(fault);
    const auto holds = condition(text);
    if (!holds) return;
    if (take_word(text, "DO")) {
      const auto number = take_last_number(text);
      if (number && *holds) return;
      if (number) return end_loop(*number);
    }
  } else if (take_word(text, "END")) {
    if (const std::string& fault = loops_of_macro().fault(); !fault.empty()) return lose(fault);
    const auto number = take_last_number(text);
    if (number) return repeat_loop(*number);
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
  const auto found = text_->find_label('N', number, begin, end, true);
  // Whether the number of a block that is left out can be reached is not stated.
  const bool is_left_out =
      found && trim_blanks(text_->line(*found)).starts_with('/') && setup_.is_block_delete_on == true;
  return is_left_out ? std::nullopt : found;
}

void ProgramRun::go_to(int number) {
  const auto block = find_block(number);
  if (!block) return lose("no block, more than one, or one that is left out has the number N" + std::to_string(number));
  if (loops_of_macro().is_entered(text_->number(at_), text_->number(*block)))
    return lose("GOTO " + std::to_string(number) + " jumps into a loop");
  next_ = *block;
}

// The program reaches from its name to the next one. It is examined once.
const BlockStructures& ProgramRun::loops_of_macro() {
  const auto is_name = [&](std::size_t i) { return capital(first_of(text_->line(i))) == 'O'; };
  std::size_t begin = at_, end = at_ + 1;
  while (begin > text_->begin() && !is_name(begin)) --begin;
  while (end < text_->end() && !is_name(end)) ++end;
  const auto [known, is_new] = structures_.try_emplace({text_, begin});
  BlockStructures& loops = known->second;
  if (!is_new) return loops;
  for (std::size_t i = begin; i < end; ++i) {
    const auto mark = loop_mark_of(std::string(text_->line(i)));
    if (!mark || (mark->is_skippable && setup_.is_block_delete_on == true)) continue;
    const std::string number = mark->number ? std::to_string(*mark->number) : "";
    if (mark->is_skippable && !setup_.is_block_delete_on)
      loops.refuse("the loop DO" + number + " has a block in line " + std::to_string(text_->number(i)) +
                   " that a switch of the control may leave out; expected --block-delete on or off");
    loops.add(text_->number(i), mark->is_end
                                    ? StructureWord{StructureWord::Kind::end, number, "END" + number}
                                    : StructureWord{StructureWord::Kind::begin, number, "WHILE with DO" + number});
  }
  loops.finish();
  return loops;
}

// The next mark with the number of a loop must be its other end.
void ProgramRun::repeat_loop(int number) {
  for (std::size_t i = at_; i-- > text_->begin();) {
    const auto mark = loop_mark_of(std::string(text_->line(i)));
    if (!mark || mark->number != number) continue;
    if (mark->is_end || mark->is_skippable) break;
    next_ = i;
    return;
  }
  lose("END" + std::to_string(number) + " has no WHILE before it, or one that a switch may leave out");
}

void ProgramRun::end_loop(int number) {
  for (std::size_t i = at_ + 1; i < text_->end(); ++i) {
    const auto mark = loop_mark_of(std::string(text_->line(i)));
    if (!mark || mark->number != number) continue;
    if (!mark->is_end || mark->is_skippable) break;
    next_ = i + 1;
    return;
  }
  lose("a loop has no END" + std::to_string(number) + ", or one that a switch may leave out");
}

}  // namespace gouge

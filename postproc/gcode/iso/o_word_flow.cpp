#include <algorithm>
#include <cmath>

#include "lib/base/letters.h"
#include "lib/base/number_text.h"
#include "postproc/gcode/iso/program_run.h"

// O-words of LinuxCNC. Source: LinuxCNC, O Codes.

namespace gouge {
namespace {

constexpr int kMaxArguments = 30;

bool is_blank(char c) { return c == ' ' || c == '\t'; }

/// Returns the number of a label without its leading zeros: the interpreter takes o01, o1 and o<1> for one.
std::string one_spelling(std::string digits) {
  digits.erase(0, std::min(digits.find_first_not_of('0'), digits.size() - 1));
  return digits;
}

/// Takes the label behind the O: "100" or "<name>"; empty: it is computed, or none. Blanks in it have no meaning.
std::string take_label(std::string_view& text) {
  text = trim_blanks(text);
  const bool has_name = text.starts_with('<');
  std::size_t end = 0;
  if (has_name) {
    end = text.find('>');
    if (end == std::string_view::npos) return {};
    ++end;
  } else {
    while (end < text.size() && (is_digit(text[end]) || is_blank(text[end]))) ++end;
  }
  std::string label = in_small_letters(text.substr(0, end));
  std::erase_if(label, is_blank);
  text = trim_blanks(text.substr(end));
  if (!has_name) return label.empty() ? label : one_spelling(std::move(label));
  const std::string name = label.substr(1, label.size() - 2);
  const bool is_number = !name.empty() && std::ranges::all_of(name, is_digit) && one_spelling(name) == name;
  return is_number ? name : label;
}

/// Takes the word behind the label. Blanks in it have no meaning.
std::string take_keyword(std::string_view& text) {
  std::string word;
  std::size_t end = 0;
  for (; end < text.size() && (is_letter(text[end]) || is_blank(text[end])); ++end)
    if (!is_blank(text[end])) word += text[end];
  text = trim_blanks(text.substr(end));
  return in_small_letters(word);
}

struct OWord {
  std::string label, word;  ///< empty: the line has no O-word
};

/// Returns the O-word with which a line begins, behind its number and the mark for block delete.
OWord o_word_of(std::string_view line) {
  line = trim_blanks(line);
  if (line.starts_with('/')) line = trim_blanks(line.substr(1));
  if (line.starts_with('N') || line.starts_with('n')) {
    line = line.substr(1);
    while (!line.empty() && (is_blank(line[0]) || is_digit(line[0]))) line = line.substr(1);
  }
  if (!line.starts_with('o') && !line.starts_with('O')) return {};
  line = line.substr(1);
  OWord found;
  found.label = take_label(line);
  found.word = take_keyword(line);
  return found;
}

bool is_among(std::string_view word, std::string_view words) {
  for (std::size_t at = 0; at <= words.size();) {
    const std::size_t end = std::min(words.find(' ', at), words.size());
    if (!word.empty() && words.substr(at, end - at) == word) return true;
    at = end + 1;
  }
  return false;
}

/// Returns what a word does in the structures of a program; none: it does nothing there. `open` are those before it.
std::optional<StructureWord> structure_word_of(const OWord& one, const BlockStructures& open) {
  using enum StructureWord::Kind;
  const auto word = [&](StructureWord::Kind kind, const std::string& pair) {
    return StructureWord{kind, one.label + " " + pair, "O" + one.label + " " + one.word};
  };
  const bool ends_do = one.word == "while" && open.is_innermost(one.label + " do");
  if (ends_do) return word(end, "do");
  if (is_among(one.word, "sub if while do repeat")) return word(begin, one.word);
  if (one.word == "elseif") return word(condition, "if");
  if (one.word == "else") return word(otherwise, "if");
  if (is_among(one.word, "endsub endif endwhile endrepeat")) return word(end, one.word.substr(3));
  return std::nullopt;
}

/// Returns whether nothing but a comment follows.
bool is_rest_empty(std::string_view rest) {
  rest = trim_blanks(rest);
  return rest.empty() || rest.front() == ';' || (rest.front() == '(' && rest.find(')') + 1 == rest.size());
}

}  // namespace

// Returns the O-word of a line that has this label; empty: it has none.
std::string ProgramRun::o_word_at(std::size_t index, const std::string& label) const {
  OWord found = o_word_of(text_->line(index));
  return found.label == label ? std::move(found.word) : std::string();
}

bool ProgramRun::is_deleted(std::size_t index) const {
  return setup_.is_block_delete_on == true && trim_blanks(text_->line(index)).starts_with('/');
}

// A text is examined once, when its first O-word runs.
const BlockStructures& ProgramRun::o_word_structures() {
  const auto [known, is_new] = structures_.try_emplace({text_, text_->begin()});
  BlockStructures& structures = known->second;
  if (!is_new) return structures;
  for (std::size_t i = text_->begin(); i < text_->end(); ++i) {
    if (is_deleted(i)) continue;
    if (const auto word = structure_word_of(o_word_of(text_->line(i)), structures))
      structures.add(text_->number(i), *word);
  }
  structures.finish();
  return structures;
}

std::optional<std::size_t> ProgramRun::find_o_word(const std::string& label, std::string_view words,
                                                   bool is_forward) const {
  if (is_forward) {
    for (std::size_t i = at_ + 1; i < text_->end(); ++i)
      if (is_among(o_word_at(i, label), words)) return i;
  } else {
    for (std::size_t i = at_; i-- > text_->begin();)
      if (is_among(o_word_at(i, label), words)) return i;
  }
  return std::nullopt;
}

void ProgramRun::run_o_word(std::string_view flow) {
  std::string_view rest = flow.substr(1);
  const std::string label = take_label(rest);
  const std::string word = take_keyword(rest);
  if (label.empty()) return lose("the label of an O-word is not read");
  if (const std::string& fault = o_word_structures().fault(); !fault.empty()) return lose(fault);
  if (word.empty() && is_rest_empty(rest)) {
    if (!is_first_block())
      lose("O" + label + " in a line of its own is read as the first block alone, which names the program");
  } else if (word == "sub") {
    define_sub(label, rest);
  } else if (word == "call") {
    call_o_word(label, rest);
  } else if (word == "endsub" || word == "return") {
    if (!is_rest_empty(rest)) return lose("a value that a subprogram returns is not read");
    if (calls_.empty() || calls_.back().label != label)
      return lose("O" + label + " " + word + " outside of its subprogram");
    if (has_open_repeat())
      return lose("O" + label + " " + word +
                  " leaves a repeat, whose count then stays; expected to leave it at its end");
    end_call();
  } else if (is_among(word, "if elseif else endif")) {
    may_jump_ = true;
    run_o_condition(label, word, rest);
  } else {
    may_jump_ = true;
    run_o_loop(label, word, rest);
  }
}

// Returns whether only comments and blank lines stand before the block that runs.
bool ProgramRun::is_first_block() const {
  if (text_ != main_ || !calls_.empty()) return false;
  for (std::size_t i = text_->begin(); i < at_; ++i)
    if (!is_rest_empty(trim_blanks(text_->line(i)))) return false;
  return true;
}

// Jumps within a subprogram. The interpreter keeps the count of a repeat that a jump leaves.
void ProgramRun::jump_to(std::size_t index) {
  if (has_open_repeat() && (index <= loops_.back().begin || index > loops_.back().end))
    return lose("a jump leaves the repeat O" + loops_.back().label +
                ", whose count then stays; expected to leave it at its end");
  next_ = index;
}

bool ProgramRun::has_open_repeat() const { return !loops_.empty() && loops_.back().depth == calls_.size(); }

// A subprogram is known from here on. Its blocks run where it is called.
void ProgramRun::define_sub(const std::string& label, std::string_view rest) {
  const auto end = find_o_word(label, "endsub", true);
  if (!end || !is_rest_empty(rest)) return lose("O" + label + " sub has no endsub");
  if (!calls_.empty() || is_in_structure(at_))
    return lose("O" + label + " sub stands in a subprogram, a loop or a condition; expected it outside of them");
  if (!subs_.try_emplace(label, Sub{text_, at_ + 1}).second)
    return lose("O" + label + " sub is already defined where the program runs over it");
  jump_to(*end + 1);
}

// Returns whether a condition or a loop is open at a line.
bool ProgramRun::is_in_structure(std::size_t index) const {
  std::vector<OWord> open;
  for (std::size_t i = text_->begin(); i < index; ++i) {
    const OWord one = o_word_of(text_->line(i));
    const auto is_pair = [&](const OWord& other) { return other.label == one.label; };
    const auto pair = std::find_if(open.rbegin(), open.rend(), is_pair);
    const bool ends_do = one.word == "while" && pair != open.rend() && pair->word == "do";
    const bool ends = ends_do || is_among(one.word, "endif endwhile endrepeat endsub");
    if (ends && pair != open.rend()) open.erase(std::next(pair).base());
    if (!ends && is_among(one.word, "if while repeat do sub")) open.push_back(one);
  }
  return !open.empty();
}

// The order of the interpreter: a subprogram that is defined, a file of its name, a subprogram behind the call.
// Source: src/emc/rs274ngc/interp_o_word.cc, control_back_to.
std::optional<ProgramRun::Sub> ProgramRun::find_sub(const std::string& label) {
  if (const auto known = subs_.find(label); known != subs_.end()) return known->second;
  const auto behind = find_o_word(label, "sub", true);
  const std::string name = label.starts_with('<') ? label.substr(1, label.size() - 2) : label;
  const ProgramText* const other = beside(name + ".ngc");
  if (behind && other != nullptr) {
    lose("O" + label + " is called before its sub, and " + name +
         ".ngc is beside the file; expected the sub before the call, or one of both");
    return std::nullopt;
  }
  const ProgramText* const before = std::exchange(text_, other != nullptr ? other : text_);
  std::optional<std::size_t> line = behind;
  for (std::size_t i = text_->begin(); other != nullptr && i < text_->end() && !line; ++i)
    if (o_word_at(i, label) == "sub") line = i;
  const bool is_nested = line && is_in_structure(*line);
  const Sub found{text_, line.value_or(0) + 1};
  text_ = before;
  if (!line)
    lose("subprogram O" + label + " is not defined before its call, nor behind it in its file, nor in " + name +
         ".ngc beside the file");
  else if (is_nested)
    lose("O" + label + " sub stands in a subprogram, a loop or a condition; expected it outside of them");
  if (!line || is_nested) return std::nullopt;
  return subs_.try_emplace(label, found).first->second;
}

void ProgramRun::call_o_word(const std::string& label, std::string_view arguments) {
  std::vector<double> values;
  while (arguments.starts_with('[')) {
    values.push_back(value_of(arguments));
    if (motion_.is_rest_unknown()) return;
    arguments = trim_blanks(arguments);
  }
  if (!is_rest_empty(arguments)) return lose("the call of O" + label + " is not read");
  const auto sub = find_sub(label);
  if (!sub) return;
  begin_call(*sub->text, sub->begin, 1, true);
  if (motion_.is_rest_unknown()) return;
  calls_.back().label = label;
  variables_.begin_call();
  for (std::size_t k = 0; k < kMaxArguments; ++k)
    variables_.set(std::to_string(k + 1), k < values.size() ? values[k] : 0, false);
}

// Returns whether a text that may have run holds a break. The interpreter notes a break, also one that it skips over, and
// ends the next do loop by it.
bool ProgramRun::may_have_broken() {
  const auto has_break = [](const ProgramText& text) {
    for (std::size_t i = text.begin(); i < text.end(); ++i)
      if (o_word_of(text.line(i)).word == "break") return true;
    return false;
  };
  if (searched_texts_ == besides_.size() + 1) return has_break_;
  searched_texts_ = besides_.size() + 1;
  has_break_ =
      has_break(*main_) || std::ranges::any_of(besides_, [&](const auto& one) { return has_break(one.second.text()); });
  return has_break_;
}

void ProgramRun::run_o_loop(const std::string& label, const std::string& word, std::string_view rest) {
  if (word == "do" && is_rest_empty(rest)) return;
  if (word == "while") {
    const auto begin = find_o_word(label, "do while endwhile", false);
    const bool is_end_of_do = begin && o_word_at(*begin, label) == "do";
    const auto holds = condition(rest);
    if (!holds) return;
    if (!is_rest_empty(rest)) return lose("text after the condition of O" + label);
    if (is_end_of_do) {
      if (*holds && may_have_broken())
        return lose("O" + label +
                    " do in a program with a break, which may end the loop after one pass; expected a "
                    "loop of while and endwhile");
      if (*holds) jump_to(*begin + 1);
      return;
    }
    const auto end = find_o_word(label, "endwhile", true);
    if (!end) return lose("O" + label + " while has no endwhile");
    if (!*holds) jump_to(*end + 1);
    return;
  }
  if (word == "endwhile" || word == "endrepeat") {
    const auto begin = find_o_word(label, word == "endwhile" ? "while" : "repeat", false);
    if (!begin || !is_rest_empty(rest)) return lose("O" + label + " " + word + " has no beginning");
    if (word == "endwhile") return jump_to(*begin);
    if (!loops_.empty() && loops_.back().label == label && loops_.back().depth == calls_.size()) {
      if (--loops_.back().left > 0)
        jump_to(*begin + 1);
      else
        loops_.pop_back();
      return;
    }
    return lose("O" + label + " endrepeat has no beginning");
  }
  if (word == "repeat") {
    const double times = value_of(rest);
    const auto end = find_o_word(label, "endrepeat", true);
    if (!end || !is_known(times) || !is_rest_empty(rest)) return lose("O" + label + " repeat is not read");
    const double passes = std::round(times);  // as the interpreter does: to the nearest
    const bool runs_already = std::ranges::any_of(loops_, [&](const Loop& loop) {
      return loop.label == label && (loop.depth == calls_.size() || (loop.text == text_ && loop.begin == at_));
    });
    if (runs_already)
      return lose("O" + label + " repeat runs within itself, and both have one count; expected other labels");
    if (passes < 1) return jump_to(*end + 1);
    loops_.push_back({label, text_, at_, *end, calls_.size(), static_cast<long long>(std::min(passes, 1e9))});
    return;
  }
  if ((word == "break" || word == "continue") && is_rest_empty(rest)) {
    const auto end = find_o_word(label, "endwhile", true);
    if (!end || o_word_at(find_o_word(label, "do while repeat", false).value_or(at_), label) != "while")
      return lose("O" + label + " " + word + " is read in loops of while alone");
    return jump_to(word == "break" ? *end + 1 : *end);
  }
  lose("the O-word '" + word + "' is not read");
}

void ProgramRun::run_o_condition(const std::string& label, const std::string& word, std::string_view rest) {
  if (word == "endif") {
    if (!is_rest_empty(rest)) lose("text after O" + label + " endif");
    return;
  }
  if (word != "if") {  // reached from the branch before it, which ran
    const auto end = find_o_word(label, "endif", true);
    if (!end) return lose("O" + label + " " + word + " has no endif");
    return jump_to(*end + 1);
  }
  std::size_t branch = at_;
  while (true) {
    const auto holds = condition(rest);
    if (!holds) return;
    if (!is_rest_empty(rest)) return lose("text after the condition of O" + label);
    if (*holds) return jump_to(branch + 1);
    const std::size_t before = std::exchange(at_, branch);
    const auto following = find_o_word(label, "elseif else endif", true);
    at_ = before;
    if (!following) return lose("O" + label + " if has no endif");
    branch = *following;
    if (o_word_at(branch, label) != "elseif") return jump_to(branch + 1);
    const std::string_view line = text_->line(branch);
    rest = line.substr(std::min(line.find('['), line.size()));
  }
}

}  // namespace gouge

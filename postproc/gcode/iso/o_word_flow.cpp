#include <algorithm>
#include <cmath>

#include "lib/base/letters.h"
#include "lib/base/number_text.h"
#include "postproc/gcode/iso/program_run.h"

// O-words of LinuxCNC. Source: LinuxCNC, O Codes.

namespace gouge {
namespace {

constexpr int kMaxArguments = 30;

/// Takes the label behind the O: "100" or "<name>"; empty: it is computed, or none.
std::string take_label(std::string_view& text) {
  text = trim_blanks(text);
  std::size_t end = 0;
  if (text.starts_with('<')) {
    end = text.find('>');
    if (end == std::string_view::npos) return {};
    ++end;
  } else {
    while (end < text.size() && text[end] >= '0' && text[end] <= '9') ++end;
  }
  std::string label = in_small_letters(text.substr(0, end));
  std::erase(label, ' ');
  text = trim_blanks(text.substr(end));
  return label;
}

std::string take_keyword(std::string_view& text) {
  text = trim_blanks(text);
  std::size_t end = 0;
  const std::string all = in_small_letters(text);
  while (end < all.size() && is_small(all[end])) ++end;
  text = trim_blanks(text.substr(end));
  return all.substr(0, end);
}

bool is_among(std::string_view word, std::string_view words) {
  for (std::size_t at = 0; at <= words.size();) {
    const std::size_t end = std::min(words.find(' ', at), words.size());
    if (!word.empty() && words.substr(at, end - at) == word) return true;
    at = end + 1;
  }
  return false;
}

/// Returns whether nothing but a comment follows.
bool is_rest_empty(std::string_view rest) {
  rest = trim_blanks(rest);
  return rest.empty() || rest.front() == ';' || (rest.front() == '(' && rest.find(')') + 1 == rest.size());
}

}  // namespace

// Returns the O-word of a line that has this label; empty: it has none.
std::string ProgramRun::o_word_at(std::size_t index, const std::string& label) const {
  std::string_view line = trim_blanks(text_->line(index));
  if (line.starts_with('N') || line.starts_with('n')) {
    line = line.substr(1);
    while (!line.empty() && (line[0] == ' ' || (line[0] >= '0' && line[0] <= '9'))) line = line.substr(1);
  }
  if (!line.starts_with('o') && !line.starts_with('O')) return {};
  line = line.substr(1);
  return take_label(line) == label ? take_keyword(line) : std::string();
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
  if (word == "sub") {
    const auto end = find_o_word(label, "endsub", true);
    if (!end || !is_rest_empty(rest)) return lose("O" + label + " sub has no endsub");
    next_ = *end + 1;
  } else if (word == "call") {
    call_o_word(label, rest);
  } else if (word == "endsub" || word == "return") {
    if (!is_rest_empty(rest)) return lose("a value that a subprogram returns is not read");
    if (calls_.empty()) return lose("O" + label + " " + word + " outside of its subprogram");
    end_call();
  } else if (is_among(word, "if elseif else endif")) {
    run_o_condition(label, word, rest);
  } else {
    run_o_loop(label, word, rest);
  }
}

void ProgramRun::call_o_word(const std::string& label, std::string_view arguments) {
  std::vector<double> values;
  while (arguments.starts_with('[')) {
    values.push_back(value_of(arguments));
    if (motion_.is_rest_unknown()) return;
    arguments = trim_blanks(arguments);
  }
  if (!is_rest_empty(arguments)) return lose("the call of O" + label + " is not read");
  const ProgramText* text = nullptr;
  std::optional<std::size_t> begin;
  const auto find_in = [&](const ProgramText& in) {
    const ProgramText* const before = std::exchange(text_, &in);
    for (std::size_t i = in.begin(); i < in.end() && !begin; ++i)
      if (o_word_at(i, label) == "sub") begin = i + 1;
    text_ = before;
    if (begin) text = &in;
  };
  find_in(*text_);
  if (!begin && text_ != main_) find_in(*main_);
  if (!begin) {
    std::string name = label.starts_with('<') ? label.substr(1, label.size() - 2) : label;
    if (const ProgramText* const other = beside(name + ".ngc")) find_in(*other);
  }
  if (!begin) return lose("subprogram O" + label + " is neither in the file nor beside it");
  begin_call(*text, *begin, 1, true);
  if (motion_.is_rest_unknown()) return;
  variables_.begin_call();
  for (std::size_t k = 0; k < kMaxArguments; ++k)
    variables_.set(std::to_string(k + 1), k < values.size() ? values[k] : 0, false);
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
      if (*holds) next_ = *begin + 1;
      return;
    }
    const auto end = find_o_word(label, "endwhile", true);
    if (!end) return lose("O" + label + " while has no endwhile");
    if (!*holds) next_ = *end + 1;
    return;
  }
  if (word == "endwhile" || word == "endrepeat") {
    const auto begin = find_o_word(label, word == "endwhile" ? "while" : "repeat", false);
    if (!begin || !is_rest_empty(rest)) return lose("O" + label + " " + word + " has no beginning");
    if (word == "endwhile") {
      next_ = *begin;
      return;
    }
    if (!loops_.empty() && loops_.back().label == label && loops_.back().depth == calls_.size()) {
      if (--loops_.back().left > 0)
        next_ = *begin + 1;
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
    if (passes < 1) {
      next_ = *end + 1;
      return;
    }
    loops_.push_back({label, calls_.size(), static_cast<long long>(std::min(passes, 1e9))});
    return;
  }
  if ((word == "break" || word == "continue") && is_rest_empty(rest)) {
    const auto end = find_o_word(label, "endwhile", true);
    if (!end || o_word_at(find_o_word(label, "do while repeat", false).value_or(at_), label) != "while")
      return lose("O" + label + " " + word + " is read in loops of while alone");
    next_ = word == "break" ? *end + 1 : *end;
    return;
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
    next_ = *end + 1;
    return;
  }
  std::size_t branch = at_;
  while (true) {
    const auto holds = condition(rest);
    if (!holds) return;
    if (!is_rest_empty(rest)) return lose("text after the condition of O" + label);
    if (*holds) {
      next_ = branch + 1;
      return;
    }
    const std::size_t before = std::exchange(at_, branch);
    const auto following = find_o_word(label, "elseif else endif", true);
    at_ = before;
    if (!following) return lose("O" + label + " if has no endif");
    branch = *following;
    if (o_word_at(branch, label) != "elseif") {
      next_ = branch + 1;
      return;
    }
    const std::string_view line = text_->line(branch);
    rest = line.substr(std::min(line.find('['), line.size()));
  }
}

}  // namespace gouge

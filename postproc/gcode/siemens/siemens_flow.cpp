#include <algorithm>
#include <array>
#include <cmath>

#include "lib/base/letters.h"
#include "lib/base/number_text.h"
#include "postproc/gcode/siemens/siemens_expression.h"
#include "postproc/gcode/siemens/siemens_lexer.h"
#include "postproc/gcode/siemens/siemens_run.h"

// Jumps, conditions, loops, repeated sections, and declarations.
// Source: Siemens, NC programming, 12/2019, 3.1.5 to 3.1.8.

namespace gouge {
namespace {

/// Takes a name from the beginning of a text, in capitals; empty: it begins with none.
std::string take_name(std::string_view& text) {
  GcodeCursor c{text};
  c.skip_blanks();
  std::string name = read_siemens_name(c);
  if (!name.empty()) text = text.substr(c.at);
  return name;
}

std::optional<SiemensType> type_called(std::string_view name) {
  if (name == "REAL") return SiemensType::real;
  if (name == "INT") return SiemensType::integer;
  if (name == "BOOL") return SiemensType::boolean;
  return std::nullopt;
}

/// Takes "P=3" or "P3"; nothing: none is there, or it is not read.
std::optional<int> take_times(std::string_view text) {
  text = trim_blanks(text);
  if (text.empty()) return 1;
  if (text[0] != 'P' && text[0] != 'p') return std::nullopt;
  text = trim_blanks(text.substr(1));
  if (text.starts_with('=')) text = trim_blanks(text.substr(1));
  const auto number = parse_integer(text);
  constexpr int kMaxTimes = 9999;
  return number && *number >= 1 && *number <= kMaxTimes ? std::optional(static_cast<int>(*number)) : std::nullopt;
}

bool is_jump(std::string_view name) {
  return name == "GOTO" || name == "GOTOF" || name == "GOTOB" || name == "GOTOC" || name == "GOTOS";
}

bool begins_with_jump(std::string_view text) { return is_jump(take_name(text)); }

/// Returns whether a jump stands among the words of a text: "R1==1 GOTOF A", not "MYGOTO==1".
bool has_jump(std::string_view text) {
  while (!text.empty()) {
    const std::string name = take_name(text);
    if (is_jump(name)) return true;
    if (!name.empty()) continue;
    const std::size_t close = text[0] == '"' ? text.find('"', 1) : 0;
    text.remove_prefix(std::min(close, text.size() - 1) + 1);
  }
  return false;
}

}  // namespace

void SiemensRun::run_flow(const std::string& word, std::string_view rest) {
  constexpr auto kAlone = std::to_array<std::string_view>({"ELSE", "ENDIF", "ENDWHILE", "ENDFOR", "ENDLOOP"});
  const bool is_alone = std::ranges::find(kAlone, word) != kAlone.end();
  if (is_alone && !trim_blanks(rest).empty()) return lose(word + " is followed by words that are not read");
  if (const std::string fault = structure_fault(); !fault.empty()) return lose(fault);
  if (word == "IF") return run_if(rest);
  if (word == "ELSE") {
    const auto end = find_pair(at_, "IF", "ENDIF", true);
    return end ? jump_behind(*end) : lose("ELSE without ENDIF");
  }
  if (word == "ENDIF") return;
  if (word == "EXTERN") return declare_program(rest);
  if (word == "GOTO" || word == "GOTOF" || word == "GOTOB" || word == "GOTOC") return go_to(word, rest);
  if (word == "REPEATB" || (word == "REPEAT" && !trim_blanks(rest).empty())) return repeat(word, rest);
  if (word == "WHILE" || word == "FOR" || word == "LOOP" || word == "REPEAT") return run_loop(word, rest);
  if (word == "ENDWHILE" || word == "ENDFOR" || word == "ENDLOOP" || word == "UNTIL") return run_loop_end(word, rest);
  if (word == "DEF") return declare(rest);
  if (word == "PROC") return run_proc(rest);
  if (word == "RET" && trim_blanks(rest).empty()) return follow({SiemensNext::Kind::back, {}, 1});
  lose(word + " is not read");
}

std::optional<double> SiemensRun::value_of(std::string_view& text) {
  GcodeCursor cursor{text};
  const double value = read_siemens_value(cursor, variables_);
  text = text.substr(std::min(cursor.at, text.size()));
  if (cursor.error.empty()) return value;
  lose(cursor.error);
  return std::nullopt;
}

std::optional<bool> SiemensRun::condition(std::string_view& text) {
  const auto value = value_of(text);
  if (!value) return std::nullopt;
  if (is_known(*value)) return std::abs(*value) > 0;
  lose("a condition whose value is not known");
  return std::nullopt;
}

void SiemensRun::run_if(std::string_view rest) {
  const auto holds = condition(rest);
  if (!holds) return;
  if (begins_with_jump(rest)) return run_conditional_jumps(*holds, rest);
  if (!trim_blanks(rest).empty()) return lose("IF is followed by words that are not read");
  if (*holds) return;
  const auto branch = find_branch();
  return branch ? jump_behind(*branch) : lose("IF without ENDIF");
}

// IF condition GOTOF A IF condition GOTOF B: the first condition that holds jumps.
void SiemensRun::run_conditional_jumps(bool holds, std::string_view rest) {
  while (true) {
    const std::string word = take_name(rest), target = take_name(rest);
    rest = trim_blanks(rest);
    std::string_view behind = rest;
    const bool has_next = take_name(behind) == "IF";
    if (!is_jump(word) || target.empty() || (!rest.empty() && !has_next))
      return lose("a jump of IF is followed by words that are not read");
    if (holds) return go_to(word, target);
    if (!has_next) return;
    rest = behind;
    const auto next = condition(rest);
    if (!next) return;
    holds = *next;
  }
}

// Only an IF without a jump has an ENDIF.
std::string SiemensRun::flow_at(std::size_t index) const {
  const std::string_view line = without_comment(text_->program->line(index));
  std::string word = is_deleted(index) ? std::string() : flow_word_of(line);
  const std::string_view rest = word.empty() ? std::string_view() : flow_rest_at(index, word);
  if (word == "IF" && has_jump(rest)) return {};
  if (word == "REPEAT" && !trim_blanks(rest).empty()) return {};
  return word;
}

bool SiemensRun::has_mark_at(std::size_t index) const {
  return read_siemens_start(text_->program->line(index)).is_skippable;
}

bool SiemensRun::is_deleted(std::size_t index) const {
  return input_.options.setup.is_block_delete_on == true && has_mark_at(index);
}

// A block that a switch may leave out is part of no structure that is known.
bool SiemensRun::is_open_at(std::size_t index) const {
  return !input_.options.setup.is_block_delete_on && has_mark_at(index);
}

// Passes the word that ends a section, which stands alone.
void SiemensRun::jump_behind(std::size_t index) {
  const std::string word = flow_at(index);
  if (!flow_rest_at(index, word).empty()) return lose(word + " is followed by words that are not read");
  jump(index + 1);
}

std::string_view SiemensRun::flow_rest_at(std::size_t index, std::string_view word) const {
  const std::string_view line = without_comment(text_->program->line(index));
  return trim_blanks(line.substr(read_siemens_start(line).first_word)).substr(word.size());
}

std::optional<std::size_t> SiemensRun::find_pair(std::size_t from, std::string_view opening, std::string_view closing,
                                                 bool is_forward) const {
  std::size_t depth = 0;
  const std::size_t begin = text_->program->begin(), end = text_->program->end();
  for (std::size_t i = from; is_forward ? i + 1 < end : i > begin;) {
    i = is_forward ? i + 1 : i - 1;
    const std::string word = flow_at(i);
    const bool opens = word == (is_forward ? opening : closing), closes = word == (is_forward ? closing : opening);
    if ((opens || closes) && is_open_at(i)) return std::nullopt;
    if (closes && depth == 0) return i;
    if (opens) ++depth;
    if (closes) --depth;
  }
  return std::nullopt;
}

// The ELSE or ENDIF of the IF that runs.
std::optional<std::size_t> SiemensRun::find_branch() const {
  std::size_t depth = 0;
  for (std::size_t i = at_ + 1; i < text_->program->end(); ++i) {
    const std::string word = flow_at(i);
    const bool is_part = word == "IF" || word == "ELSE" || word == "ENDIF";
    if (is_part && is_open_at(i)) return std::nullopt;
    if (depth == 0 && (word == "ELSE" || word == "ENDIF")) return i;
    if (word == "IF") ++depth;
    if (word == "ENDIF") --depth;
  }
  return std::nullopt;
}

// A jump out of a section that is repeated would leave its count open.
void SiemensRun::jump(std::size_t index) {
  if (!calls_.empty() && calls_.back().is_section && (index < calls_.back().begin || index > calls_.back().end))
    return lose("a jump leaves a section that is repeated");
  next_ = index;
}

void SiemensRun::run_loop(const std::string& word, std::string_view rest) {
  if (word == "FOR") return run_for(rest, false);
  if (word != "WHILE") {
    if (!trim_blanks(rest).empty()) lose(word + " is followed by words that are not read");
    return;
  }
  const auto holds = condition(rest);
  if (!holds) return;
  if (!trim_blanks(rest).empty()) return lose("WHILE is followed by words that are not read");
  if (*holds) return;
  const auto end = find_pair(at_, "WHILE", "ENDWHILE", true);
  return end ? jump_behind(*end) : lose("WHILE without ENDWHILE");
}

void SiemensRun::run_loop_end(const std::string& word, std::string_view rest) {
  const std::string opening = word == "UNTIL" ? "REPEAT" : word.substr(3);
  const auto begin = find_pair(at_, opening, word, false);
  if (!begin) return lose(word + " without " + opening);
  if (word == "ENDFOR") {
    const std::string stated(flow_rest_at(*begin, "FOR"));
    const std::size_t end = at_;
    at_ = *begin;
    run_for(stated, true);
    at_ = end;
    return;
  }
  if (word == "ENDWHILE") return jump(*begin);
  if (word == "UNTIL") {
    const auto holds = condition(rest);
    if (!holds) return;
    if (!trim_blanks(rest).empty()) return lose("UNTIL is followed by words that are not read");
    if (*holds) return;
  }
  jump(*begin + 1);
}

// FOR variable = first TO last. At ENDFOR, with `is_next`, the variable grows by 1.
void SiemensRun::run_for(std::string_view rest, bool is_next) {
  const std::string name = take_name(rest);
  rest = trim_blanks(rest);
  if (!variables_.has(name) || !rest.starts_with('=')) return lose("FOR without a variable of the program");
  rest = rest.substr(1);
  const auto first = value_of(rest);
  if (!first) return;
  if (take_name(rest) != "TO") return lose("FOR without TO");
  const auto last = value_of(rest);
  if (!last) return;
  if (!trim_blanks(rest).empty()) return lose("FOR is followed by words that are not read");
  const auto limit = limits_.insert_or_assign({text_, at_}, is_next ? limits_[{text_, at_}] : *last).first;
  if (std::abs(limit->second - *last) > 0) return lose("a limit of FOR changes within its loop");
  set(name, is_next ? variables_.value(name) + 1 : *first);
  const double value = variables_.value(name);
  if (!is_known(value) || !is_known(*last)) return lose("a limit of FOR is not known");
  if (value <= *last) return jump(at_ + 1);
  const auto end = find_pair(at_, "FOR", "ENDFOR", true);
  return end ? jump_behind(*end) : lose("FOR without ENDFOR");
}

// N100 and N0100 in one file are a target that is not clear.
std::string SiemensRun::one_spelling(const std::string& label) {
  const bool is_number = label.size() > 1 && label[0] == 'N' && std::all_of(label.begin() + 1, label.end(), is_digit);
  if (!is_number) return label;
  const std::size_t digits = std::min(label.find_first_not_of('0', 1), label.size() - 1);
  return "N" + label.substr(digits);
}

const SiemensRun::Labels& SiemensRun::labels() {
  if (text_->labels) return *text_->labels;
  Labels made;
  for (std::size_t i = text_->program->begin(); i < text_->program->end(); ++i) {
    const SiemensLineStart start = read_siemens_start(text_->program->line(i));
    if (!start.label.empty()) made[start.label].push_back(i);
    if (!start.number.empty()) made[one_spelling("N" + std::string(start.number))].push_back(i);
  }
  text_->labels = std::move(made);
  return *text_->labels;
}

std::optional<std::size_t> SiemensRun::only_line_of(const std::string& label) {
  const auto found = labels().find(one_spelling(label));
  return found == labels().end() || found->second.size() != 1 ? std::nullopt : std::optional(found->second[0]);
}

// GOTOF looks towards the end, GOTOB towards the beginning, GOTO both. A target that occurs twice is not read.
void SiemensRun::go_to(const std::string& word, std::string_view target) {
  const std::string name = take_name(target);
  if (name.empty() || !trim_blanks(target).empty() || word == "GOTOS") return lose("the target of a jump is not read");
  const auto line = only_line_of(name);
  const bool is_behind = line && *line > at_;
  const bool is_there = line && (word == "GOTO" || word == "GOTOC" || (word == "GOTOF") == is_behind);
  if (is_there && structures().is_entered(text_->program->number(at_), text_->program->number(*line)))
    return lose(word + " " + name + " jumps into a condition or a loop");
  if (is_there) return jump(*line);
  lose("no block, or more than one, is the target " + name + " of " + word);
}

// REPEAT start [end] [P=n] runs a section again, REPEATB label [P=n] one block.
void SiemensRun::repeat(const std::string& word, std::string_view rest) {
  const std::string label = take_name(rest);
  std::string_view behind = rest;
  std::string last = take_name(behind);
  const bool is_count = last == "P" || (last.size() > 1 && last[0] == 'P' && take_times(last));
  if (is_count)
    last.clear();
  else
    rest = behind;
  const auto times = take_times(rest);
  const auto begin = only_line_of(label);
  if (!times || !begin) return lose("the section of " + word + " is not read");
  std::size_t end = *begin + 1;
  if (word == "REPEAT" && !last.empty()) {
    const auto until = only_line_of(last);
    if (!until || *until < *begin) return lose("the section of REPEAT has no end");
    end = *until + 1;
  } else if (word == "REPEAT") {
    for (end = *begin; end < text_->program->end() && end != at_; ++end)
      if (read_siemens_start(text_->program->line(end)).label == "ENDLABEL") break;
    if (end == text_->program->end()) return lose("the section of REPEAT has no end");
    if (end != at_) ++end;
  }
  if (*begin <= at_ && at_ < end) return lose("REPEAT is within the section that it repeats");
  begin_call(*text_, *begin, end, *times, true);
}

void SiemensRun::declare(std::string_view rest) {
  const std::string type_name = take_name(rest);
  const auto type = type_called(type_name);
  if (!type) return lose("DEF " + type_name + " is not read");
  while (true) {
    const std::string name = take_name(rest);
    rest = trim_blanks(rest);
    double value = 0;
    if (rest.starts_with('=')) {
      rest = rest.substr(1);
      const auto stated = value_of(rest);
      if (!stated) return;
      value = *stated;
    }
    // The name of an axis or of a code would give its words another meaning.
    const bool is_taken = name.size() < 2 || find_siemens_row(name) != nullptr || name[0] == '$';
    if (is_taken || !variables_.declare(name, *type, value)) return lose("DEF of '" + name + "' is not read");
    rest = trim_blanks(rest);
    if (rest.empty()) return;
    if (!rest.starts_with(',')) return lose("DEF is followed by text that is not read");
    rest = rest.substr(1);
  }
}

// A subprogram without parameters, and without attributes that restore codes and frames at its end.
void SiemensRun::run_proc(std::string_view rest) {
  const std::string name = take_name(rest);
  rest = trim_blanks(rest);
  if (rest.starts_with('(') && rest.ends_with(')') && trim_blanks(rest.substr(1, rest.size() - 2)).empty()) rest = {};
  if (name.empty() || !rest.empty()) lose("PROC with parameters or attributes");
}

// EXTERN NAME, EXTERN NAME(REAL,REAL): declares a subprogram, and does nothing else.
void SiemensRun::declare_program(std::string_view rest) {
  const std::string name = take_name(rest);
  rest = trim_blanks(rest);
  const bool has_types = rest.starts_with('(') && rest.find(')') + 1 == rest.size();
  if (name.empty() || (!rest.empty() && !has_types)) lose("EXTERN is followed by text that is not read");
}

}  // namespace gouge

#include "postproc/gcode/iso/program_run.h"

#include <algorithm>
#include <cmath>

#include "lib/base/letters.h"
#include "lib/base/number_text.h"
#include "lib/base/stage.h"
#include "postproc/gcode/lexing/expression.h"

namespace gouge {
namespace {

char first_letter(std::string_view line) {
  const std::string_view text = trim_blanks(line);
  return text.empty() ? '\0' : capital(text[0]);
}

}  // namespace

ProgramRun::ProgramRun(const ControlTable& control, const ProgramSetup& setup, const ProgramText& text,
                       BlockRunner& runner, ProgramMotion& motion)
    : control_(control), setup_(setup), runner_(runner), motion_(motion), main_(&text), text_(&text) {}

void ProgramRun::lose(const std::string& reason) { runner_.lose_rest(reason, main_->number(main_at_)); }

void ProgramRun::run_start(std::string_view blocks) {
  while (!blocks.empty()) {
    const std::size_t end = std::min(blocks.find('\n'), blocks.size());
    read_gcode_block(blocks.substr(0, end), control_.syntax, variables_, block_);
    motion_.begin_block(0, 0);
    if (!block_.flow.empty()) block_.error = "the blocks at the start change the order of blocks";
    if (!block_.assignments.empty()) block_.error = "the blocks at the start set variables";
    static_cast<void>(runner_.run(block_, 0));
    blocks.remove_prefix(std::min(end + 1, blocks.size()));
  }
}

void ProgramRun::run(const ProgressCall& progress, const std::string& file) {
  Stage stage(progress, "reading " + file, main_->size());
  const std::size_t most = main_->size() + kMaxRepeatedBlocks;
  next_ = main_->begin();
  for (std::size_t steps = 0; !has_ended_ && !runner_.error(); ++steps) {
    if (next_ >= text_->end()) {
      if (calls_.empty()) break;
      lose(calls_.back().has_locals ? "the file ends within subprogram O" + calls_.back().label
                                    : "the file of a subprogram ends without M99");
      end_call();
      continue;
    }
    stage.pass(steps);
    at_ = next_++;
    if (text_ == main_) main_at_ = at_;
    if (steps > most) {
      lose("the program runs more than " + std::to_string(kMaxRepeatedBlocks) +
           " blocks again: a loop may have no end");
      break;
    }
    run_block();
  }
}

void ProgramRun::run_block() {
  const std::string_view line = text_->line(at_);
  motion_.begin_block(main_at_, main_->number(main_at_));
  if (names_program(line)) return;
  read_gcode_block(line, control_.syntax, variables_, block_);
  may_jump_ = may_jump_ || block_.is_skippable || (!control_.syntax.has_o_words && !block_.flow.empty());
  if (is_left_out()) return;
  if (block_.error.empty() && !block_.flow.empty() && !motion_.is_rest_unknown()) {
    if (!block_.words.empty() || !block_.assignments.empty()) return lose("words before a statement of program flow");
    return control_.syntax.has_o_words ? run_o_word(block_.flow) : run_macro(block_.flow);
  }
  lose_at_system_variable(block_.assignments);
  const bool is_mixed = control_.syntax.has_macros && !block_.assignments.empty() && !block_.words.empty();
  if (is_mixed && block_.error.empty())
    block_.error = "#" + block_.assignments.front().variable +
                   " is set in a block with other words, and no manual states which counts first; expected a block of "
                   "its own";
  const NextBlock next = runner_.run(block_, main_->number(main_at_));
  assign(block_.assignments);
  const bool is_lost_end = motion_.is_rest_unknown() && calls_.empty() && runner_.has_end(block_);
  if (is_lost_end) end_line_ = main_->number(main_at_);
  follow(next);
}

// The control changes an offset, a length or another value of its own by it.
void ProgramRun::lose_at_system_variable(const std::vector<GcodeAssignment>& assignments) {
  for (const GcodeAssignment& one : assignments)
    if (is_system_variable(one.variable, control_.syntax))
      return lose("#" + one.variable + ", a variable of the control, is set");
}

void ProgramRun::assign(const std::vector<GcodeAssignment>& assignments) {
  for (const GcodeAssignment& one : assignments) variables_.set(one.variable, one.value, one.is_rounded);
}

// Returns the text behind O1000, :1000 or <name> that is no comment.
std::string_view ProgramRun::behind_name(std::string_view line) {
  line = trim_blanks(line);
  const std::size_t close = line[0] == '<' ? line.find('>') : 0;
  line.remove_prefix(std::min(close, line.size() - 1) + 1);
  while (!line.empty() && (is_digit(line[0]) || line[0] == ' ' || line[0] == '\t')) line.remove_prefix(1);
  while (line.starts_with('(') && line.find(')') != std::string_view::npos)
    line = trim_blanks(line.substr(line.find(')') + 1));
  return line == ";" ? std::string_view() : line;
}

// On controls whose programs have numbers, O with the number begins a program.
bool ProgramRun::names_program(std::string_view line) {
  if (control_.syntax.has_o_words) return false;
  const char first = first_letter(line);
  if (first != 'O' && first != '<' && first != ':') return false;
  const bool is_beginning = at_ == text_->begin() || (!calls_.empty() && at_ == calls_.back().begin);
  if (!is_beginning) lose("the program runs into the next one, which begins here; expected M30 or M99 before it");
  const std::string_view words = behind_name(line);
  const bool may_be_block = words.find_first_of("0123456789#(") != std::string_view::npos;
  if (may_be_block)
    lose("'" + std::string(words.substr(0, 20)) +
         "' stands in the block of the program's name; expected a block of its own");
  return true;
}

bool ProgramRun::is_left_out() {
  const bool is_empty = block_.words.empty() && block_.assignments.empty() && block_.flow.empty();
  if (!block_.is_skippable || (is_empty && block_.error.empty())) return false;
  if (setup_.is_block_delete_on) return *setup_.is_block_delete_on;
  lose("a block that a switch of the control leaves out; expected --block-delete on or off");
  return true;
}

void ProgramRun::follow(const NextBlock& next) {
  switch (next.kind) {
    case NextBlock::Kind::following:
      return;
    case NextBlock::Kind::end:
      has_ended_ = true;
      end_line_ = main_->number(main_at_);
      return;
    case NextBlock::Kind::call_program:
    case NextBlock::Kind::call_block:
      return call(next);
    case NextBlock::Kind::back:
      if (!calls_.empty()) return end_call();
      has_ended_ = begins_again_ = true;
      return lose("M99 in the main program begins it again, and its later passes are not read; expected M30");
  }
}

void ProgramRun::call(const NextBlock& next) {
  if (next.kind == NextBlock::Kind::call_block) {
    const auto block = find_block(next.target);
    if (!block)
      return lose("no block, more than one, or one that is left out has the number N" + std::to_string(next.target));
    if (loops_of_macro().is_entered(text_->number(at_), text_->number(*block)))
      return lose("a call begins within a loop, at N" + std::to_string(next.target));
    return begin_call(*text_, *block, next.times, false);
  }
  if (may_count_repeats(next.target))
    return lose("P of a call has more than " + std::to_string(control_.program_digits) +
                " digits, of which the first may be a count of repeats; expected at most " +
                std::to_string(control_.program_digits) + ", and L for repeats");
  const auto inside = main_->find_label('O', next.target, main_->begin(), main_->end(), true);
  const ProgramText* const other = beside("O" + std::to_string(next.target));
  if (inside && other != nullptr)
    return lose("program O" + std::to_string(next.target) + " is in the file and beside it; expected one of both");
  if (inside) return begin_call(*main_, *inside, next.times, false);
  if (other == nullptr)
    return lose("program O" + std::to_string(next.target) +
                " is neither in the file nor beside it; expected one file such as O" + std::to_string(next.target) +
                ".nc");
  const auto named = other->find_label('O', next.target, other->begin(), other->end(), true);
  const bool has_names = other->begin() < other->end() && first_letter(other->line(other->begin())) == 'O';
  if (!named && has_names)
    return lose("the file of program O" + std::to_string(next.target) + " holds another program");
  begin_call(*other, named.value_or(other->begin()), next.times, false);
}

// On a control whose program numbers are short, P30100 is three times O0100; so is P00030100.
bool ProgramRun::may_count_repeats(int program) const {
  if (control_.program_digits == 0) return false;
  std::size_t digits = std::to_string(program).size();
  const std::string_view line = text_->line(at_);
  for (const GcodeWord& word : block_.words) {
    const std::string_view written = line.substr(word.first_byte, word.last_byte - word.first_byte);
    const bool is_expression = written.find_first_of("#[") != std::string_view::npos;
    if (word.letter != 'P' || is_expression) continue;
    digits = std::max(digits, static_cast<std::size_t>(std::ranges::count_if(written, is_digit)));
  }
  return digits > control_.program_digits;
}

void ProgramRun::begin_call(const ProgramText& text, std::size_t begin, int times, bool has_locals) {
  if (calls_.size() >= kMaxCalls) return lose("programs call each other without an end");
  calls_.push_back({text_, next_, begin, times, has_locals, {}});
  // A call returns to the file it came from, at the block after it.
  text_ = &text;
  next_ = begin;
}

void ProgramRun::end_call() {
  Call& call = calls_.back();
  if (--call.times > 0) {
    next_ = call.begin;
    return;
  }
  if (call.has_locals) variables_.end_call();
  text_ = call.text;
  next_ = call.back;
  calls_.pop_back();
  std::erase_if(loops_, [&](const Loop& loop) { return loop.depth > calls_.size(); });
}

const ProgramText* ProgramRun::beside(const std::string& name) {
  if (const auto known = besides_.find(name); known != besides_.end()) return &known->second.text();
  if (!setup_.read_beside) return nullptr;
  std::vector<std::string> texts = setup_.read_beside(name);
  if (texts.size() > 1) lose("several files beside the program are called " + name + "; expected one");
  if (texts.size() != 1) return nullptr;
  return &besides_.try_emplace(name, std::move(texts.front())).first->second.text();
}

double ProgramRun::value_of(std::string_view& text) {
  GcodeCursor cursor{text};
  bool has_point = false;
  const double value = read_value(cursor, control_.syntax, variables_, has_point);
  if (!cursor.error.empty()) lose(cursor.error);
  text = text.substr(std::min(cursor.at, text.size()));
  return cursor.error.empty() ? value : kUnknownValue;
}

std::optional<bool> ProgramRun::condition(std::string_view& text) {
  const double value = value_of(text);
  if (is_known(value)) return std::abs(value) > 0;
  lose("a condition whose value is not known");
  return std::nullopt;
}

}  // namespace gouge

#include "postproc/gcode/siemens/siemens_run.h"

#include <algorithm>
#include <cmath>

#include "lib/base/letters.h"
#include "lib/base/number_text.h"
#include "lib/base/stage.h"
#include "postproc/gcode/siemens/siemens_lexer.h"

namespace gouge {

SiemensRun::SiemensRun(const ProgramInput& input, const ProgramText& text, SiemensRunner& runner)
    : input_(input), runner_(runner), main_(&text), main_text_{&text, {}, {}}, text_(&main_text_) {}

void SiemensRun::lose(const std::string& reason) { runner_.lose_rest(reason, main_->number(main_at_)); }

void SiemensRun::run_start(std::string_view blocks) {
  while (!blocks.empty()) {
    const std::size_t end = std::min(blocks.find('\n'), blocks.size());
    read_siemens_block(blocks.substr(0, end), variables_, block_);
    input_.motion.begin_block(0, 0);
    if (!block_.flow_word.empty() || !block_.assignments.empty())
      block_.error = "the blocks at the start change variables or the order of blocks";
    const SiemensNext next = runner_.run(block_, 0);
    if (next.kind != SiemensNext::Kind::following)
      runner_.lose_rest("the blocks at the start call or end a program", 0);
    blocks.remove_prefix(std::min(end + 1, blocks.size()));
  }
}

void SiemensRun::run() {
  Stage stage(input_.progress, "reading " + input_.path.file, main_->size());
  const std::size_t most = main_->size() + kMaxRepeatedBlocks;
  next_ = main_->begin();
  for (std::size_t steps = 0; !has_ended_ && !runner_.error(); ++steps) {
    if (!calls_.empty() && next_ == calls_.back().end && calls_.back().is_section) {
      end_call();
      continue;
    }
    if (next_ >= text_->program->end()) {
      if (calls_.empty()) break;
      if (!calls_.back().is_section) lose("the file of a subprogram ends without M17 or RET");
      end_call();
      continue;
    }
    stage.pass(steps);
    at_ = next_++;
    if (text_ == &main_text_) main_at_ = at_;
    if (steps > most) {
      lose("the program runs more than " + std::to_string(kMaxRepeatedBlocks) +
           " blocks again: a loop may have no end");
      break;
    }
    run_block();
  }
}

void SiemensRun::run_block() {
  input_.motion.begin_block(main_at_, main_->number(main_at_));
  read_siemens_block(text_->program->line(at_), variables_, block_);
  const bool is_jump = !block_.flow_word.empty() && block_.flow_word != "DEF" && block_.flow_word != "PROC";
  may_jump_ = may_jump_ || block_.is_skippable || is_jump;
  if (is_left_out(block_.is_skippable, block_.is_empty())) return;
  if (!block_.flow_word.empty() && !input_.motion.is_rest_unknown()) {
    const std::string word = block_.flow_word;
    const std::string rest(block_.flow_rest);
    return run_flow(word, rest);
  }
  find_replaced_cycle();
  const SiemensNext next = runner_.run(block_, main_->number(main_at_));
  for (const SiemensAssignment& one : block_.assignments) set(one.variable, one.value);
  follow(next);
}

void SiemensRun::set(const std::string& variable, double value) {
  const double before = variables_.value(variable);
  variables_.set(variable, value);
  const bool is_same = std::abs(variables_.value(variable) - before) <= 0;
  if (!is_same) runner_.note_change(SiemensVariables::one_spelling(variable), main_->number(main_at_));
}

// Source: NC programming, 12/2019, p. 559: the folder of the program comes before that of the cycles.
void SiemensRun::find_replaced_cycle() {
  if (input_.motion.is_rest_unknown()) return;
  constexpr std::size_t kMinCycleName = 7;  // as CYCLE81; shorter words are looked up once, by the runner
  for (const SiemensWord& word : block_.words) {
    if (word.name.size() < kMinCycleName) continue;
    const SiemensRow* const row = word.form == SiemensWord::Form::number ? nullptr : find_siemens_row(word.name);
    const bool is_cycle =
        row != nullptr && (row->meaning == SiemensMeaning::drill || row->meaning == SiemensMeaning::swivel ||
                           row->meaning == SiemensMeaning::smoothing);
    if (!is_cycle) continue;
    auto known = replaced_.find(word.name);
    if (known == replaced_.end()) {
      const bool is_there = !texts_beside(word.name, "SPF").empty() || !texts_beside(word.name, "MPF").empty();
      known = replaced_.emplace(word.name, is_there || holds_program(word.name)).first;
    }
    if (known->second)
      return lose("a program called " + word.name +
                  " is beside the file, and may run in place of the cycle; expected no program of that name");
  }
}

bool SiemensRun::is_left_out(bool is_skippable, bool is_empty) {
  if (!is_skippable || is_empty) return false;
  if (input_.options.setup.is_block_delete_on) return *input_.options.setup.is_block_delete_on;
  lose("a block that a switch of the control leaves out; expected --block-delete on or off");
  return true;
}

void SiemensRun::follow(const SiemensNext& next) {
  switch (next.kind) {
    case SiemensNext::Kind::following:
      return;
    case SiemensNext::Kind::call:
      return call(next);
    case SiemensNext::Kind::back:
      // A section that is repeated ends with the program that it is part of.
      while (!calls_.empty() && calls_.back().is_section) calls_.pop_back();
      if (!calls_.empty()) return end_call();
      [[fallthrough]];
    case SiemensNext::Kind::end:
      if (std::ranges::any_of(calls_, [](const Call& one) { return !one.is_section; }))
        return lose("the end of a program in a subprogram; expected M17 or RET");
      has_ended_ = true;
      end_line_ = main_->number(main_at_);
      return;
  }
}

// The program in a file beside must be that of its name: %_N_L10_SPF, or a file without such a head.
bool SiemensRun::holds_other_program(std::string_view bytes, const std::string& name) {
  const std::string text = in_capitals(bytes), head = "%_N_";
  for (std::size_t at = text.find(head); at != std::string::npos; at = text.find(head, at + 1))
    if (text.compare(at + head.size(), name.size() + 1, name + "_") != 0) return true;
  return false;
}

// An archive holds several programs, each behind its name: %_N_L10_SPF.
bool SiemensRun::holds_program(const std::string& name) const {
  return std::string_view(input_.path.source).find("%_N_" + name + "_") != std::string_view::npos;
}

void SiemensRun::call(const SiemensNext& next) {
  const bool is_known = besides_.contains(next.program);  // the file is searched once for each program
  if (!is_known && holds_program(next.program))
    return lose("the file itself holds " + next.program +
                ", and programs of archives are not read; expected a file each");
  Text* const text = beside(next.program);
  if (input_.motion.is_rest_unknown()) return;
  if (text == nullptr)
    return lose(next.program + " is not in the table of Siemens 840D, and no program of that name is beside the file");
  begin_call(*text, text->program->begin(), std::numeric_limits<std::size_t>::max(), next.times, false);
}

void SiemensRun::begin_call(Text& text, std::size_t begin, std::size_t end, int times, bool is_section) {
  if (calls_.size() >= kMaxCalls) return lose("programs call each other without an end");
  calls_.push_back({text_, next_, begin, end, times, is_section});
  if (!is_section) variables_.begin_call();
  text_ = &text;
  next_ = begin;
}

void SiemensRun::end_call() {
  Call& call = calls_.back();
  const bool is_again = --call.times > 0;
  if (!call.is_section) variables_.end_call();
  if (is_again) {
    if (!call.is_section) variables_.begin_call();
    next_ = call.begin;
    return;
  }
  text_ = call.text;
  next_ = call.back;
  calls_.pop_back();
}

// The control has no small letters in the names of programs. Files that differ are several programs.
std::vector<std::string> SiemensRun::texts_beside(const std::string& name, const std::string& ending) const {
  std::vector<std::string> texts;
  if (!input_.options.setup.read_beside) return texts;
  for (const std::string& one : {name, in_small_letters(name)})
    for (const std::string& end : {ending, in_small_letters(ending)}) {
      for (std::string& bytes : input_.options.setup.read_beside(one + "." + end))
        if (std::ranges::find(texts, bytes) == texts.end()) texts.push_back(std::move(bytes));
    }
  return texts;
}

SiemensRun::Text* SiemensRun::beside(const std::string& name) {
  if (const auto known = besides_.find(name); known != besides_.end()) return &known->second.text;
  std::vector<std::string> texts = texts_beside(name, "SPF");
  if (texts.empty()) texts = texts_beside(name, "MPF");
  if (texts.size() > 1) {
    lose("several files beside the program are called " + name + ", with capitals and small letters; expected one");
    return nullptr;
  }
  if (texts.empty() || holds_other_program(texts.front(), name)) return nullptr;
  return &besides_.try_emplace(name, std::move(texts.front())).first->second.text;
}

}  // namespace gouge

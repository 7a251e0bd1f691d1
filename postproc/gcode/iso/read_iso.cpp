#include "postproc/gcode/iso/read_iso.h"

#include <algorithm>

#include "lib/base/file_kind.h"
#include "lib/base/number_text.h"
#include "postproc/gcode/iso/other_program.h"
#include "postproc/gcode/iso/program_run.h"

namespace gouge {
namespace {

constexpr std::size_t kLinesOfRecognition = 300;

/// Returns whether a code that applies a tool length stands in the text. Comments count too: then a length must be given
/// that would not be needed otherwise.
bool may_apply_lengths(std::string_view text) {
  for (const std::string_view code :
       {"G43", "g43", "G 43", "g 43", "G44", "g44", "G043", "G234", "g234", "G#", "g#", "G[", "g["})
    if (text.find(code) != std::string_view::npos) return true;
  return false;
}

/// Text before the first percent sign and after the second is no part of the program. Blocks there are not overlooked.
void find_blocks_outside(const ProgramText& text, const ControlTable& control, BlockRunner& runner) {
  GcodeBlock block;
  const GcodeVariables variables;
  const auto is_block = [&](std::size_t index) {
    const std::string_view line = trim_blanks(text.line(index));
    if (line.starts_with('%')) return false;
    read_gcode_block(line, control.syntax, variables, block);
    return block.error.empty() && (!block.words.empty() || !block.flow.empty() || !block.assignments.empty()) &&
           block.flow.empty();
  };
  for (std::size_t i = 0; i < text.begin(); ++i)
    if (is_block(i))
      return runner.lose_rest("a block before the percent sign at which the program begins", text.number(i));
}

}  // namespace

bool is_iso_program(std::string_view bytes) {
  bytes = without_byte_order_mark(bytes);
  GcodeBlock block;
  const GcodeVariables variables;
  const GcodeSyntax syntax = {.has_o_words = true, .has_macros = false, .has_named_variables = true};
  std::size_t blocks = 0, others = 0;
  for (std::size_t at = 0, lines = 0; at < bytes.size() && lines < kLinesOfRecognition; ++lines) {
    const std::size_t end = std::min(bytes.find('\n', at), bytes.size());
    const std::string_view line = trim_blanks(bytes.substr(at, end - at));
    at = end + 1;
    if (line.empty() || line.front() == '%') continue;
    read_gcode_block(line, syntax, variables, block);
    if (!block.error.empty() || (block.words.empty() && block.comment.empty() && block.assignments.empty()))
      others += block.flow.empty() ? 1U : 0U;
    else if (!block.words.empty())
      ++blocks;
  }
  return blocks > 2 && blocks > 4 * others;
}

ProgramFacts run_iso(const ControlTable& control, const ProgramInput& input) {
  const ProgramText text(input.path.source, input.path.statements);
  const CodeIndex index(control, input.options.harmless_words);
  BlockRunner runner(index, input);
  if (control.has_straight_rapids) input.motion.run_rapids_together();
  if (!may_apply_lengths(input.path.source)) input.motion.omit_lengths();
  ProgramRun run(control, input.options.setup, text, runner, input.motion);
  run.run_start(control.start);
  run.run_start(input.options.setup.start);
  find_blocks_outside(text, control, runner);
  run.run(input.progress, input.path.file);
  ProgramFacts facts;
  facts.unit_line = runner.unit_line();
  facts.has_assumed_unit = runner.has_assumed_unit();
  facts.unit_word = input.path.unit == LengthUnit::inch ? "G20" : "G21";
  facts.offset_line = runner.offset_line();
  facts.end_line = run.end_line();
  facts.error = runner.error();
  facts.other = find_other_program(text, index, input.motion.has_run(), run.may_jump());
  if (facts.end_line == 0 && text.has_end_mark() && !run.begins_again()) facts.end_line = text.number(text.end());
  return facts;
}

}  // namespace gouge

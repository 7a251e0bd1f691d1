#include "postproc/gcode/siemens/read_siemens.h"

#include <algorithm>
#include <array>

#include "lib/base/letters.h"
#include "lib/base/number_text.h"
#include "postproc/gcode/siemens/siemens_lexer.h"
#include "postproc/gcode/siemens/siemens_run.h"

namespace gouge {
namespace {

constexpr std::size_t kLinesToRecognise = 300;

constexpr auto kMarks = std::to_array<std::string_view>(
    {"TRAORI", "TRAFOOF", "SUPA", "CYCLE800", "CYCLE832", "CYCLE81", "DEF REAL", "G710", "MCALL"});

/// Returns whether a line names the program in the memory of a Siemens control: "%_N_PART_MPF" or ";$PATH=/_N_MPF_DIR".
bool is_name_in_memory(std::string_view line) {
  const std::string text = in_capitals(line);
  if (text.starts_with(";$PATH=")) return true;
  return text.starts_with("%_N_") && (text.ends_with("_MPF") || text.ends_with("_SPF"));
}

bool is_mark_in(std::string_view line) {
  const std::string text = in_capitals(without_comment(line));
  return std::ranges::any_of(kMarks, [&](std::string_view mark) { return text.find(mark) != std::string::npos; });
}

/// Returns whether a program changes the tool by M6. Then T only prepares it.
bool has_tool_code(const ProgramText& text) {
  const SiemensVariables variables;
  SiemensBlock block;
  for (std::size_t i = text.begin(); i < text.end(); ++i) {
    const std::string_view line = text.line(i);
    if (line.find('M') == std::string_view::npos && line.find('m') == std::string_view::npos) continue;
    read_siemens_block(line, variables, block);
    if (std::ranges::find(block.words, "M6", &SiemensWord::name) != block.words.end()) return true;
  }
  return false;
}

/// Text before a percent sign that is not in the first line would be left out unseen.
void find_text_outside(const ProgramText& text, SiemensRunner& runner) {
  SiemensBlock block;
  const SiemensVariables variables;
  for (std::size_t i = 0; i < text.begin(); ++i) {
    read_siemens_block(text.line(i), variables, block);
    if (!block.is_empty())
      return runner.lose_rest("a block before the percent sign at which the program begins", text.number(i));
  }
}

/// Programs of an archive stand behind their names: %_N_A_MPF. Which of several main programs runs is not stated.
void find_other_programs(const ProgramText& text, const SourceStatements& lines, SiemensRunner& runner) {
  std::size_t heads = 0, main_programs = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!text.line(i).starts_with('%')) continue;
    const std::string line = in_capitals(trim_blanks(text.line(i)));
    if (!line.starts_with("%_N_")) continue;
    const bool is_main = line.ends_with("_MPF");
    main_programs += is_main ? 1U : 0U;
    const bool is_other = ++heads > 1 && is_main && (main_programs > 1 || heads > main_programs);
    if (is_other)
      return runner.lose_rest(
          "the file is an archive with another program, " + line.substr(1) + "; expected a file each", text.number(i));
  }
}

bool moves(const SiemensBlock& block) {
  return std::ranges::any_of(block.words, [](const SiemensWord& word) {
    return word.name.size() == 1 && std::string_view("XYZABC").find(word.name[0]) != std::string_view::npos;
  });
}

/// Finds the first motion that does not run: behind the end of the program, if nothing may lead there, or behind the percent
/// sign at the end. Subprograms of an archive run by calls alone.
std::optional<OtherProgram> find_blocks_behind(const ProgramText& text, const std::vector<bool>& has_run,
                                               bool may_jump) {
  SiemensBlock block;
  const SiemensVariables variables;
  std::size_t last = text.begin();
  for (std::size_t i = text.begin(); i < text.end(); ++i)
    if (has_run[i]) last = i + 1;
  bool is_subprogram = false;
  for (std::size_t i = may_jump ? text.end() : last; i < text.size(); ++i) {
    const std::string line = in_capitals(trim_blanks(text.line(i)));
    if (line.starts_with('%')) is_subprogram = line.ends_with("_SPF");
    if (line.starts_with('%') || is_subprogram) continue;
    read_siemens_block(text.line(i), variables, block);
    if (block.error.empty() && moves(block)) return OtherProgram{kBlocksBehindEnd, text.number(i)};
  }
  return std::nullopt;
}

}  // namespace

bool is_siemens_program(std::string_view bytes) {
  std::size_t blocks = 0, others = 0;
  bool has_mark = false;
  for (std::size_t at = 0, lines = 0; at < bytes.size() && lines < kLinesToRecognise; ++lines) {
    const std::size_t end = std::min(bytes.find('\n', at), bytes.size());
    const std::string_view line = trim_blanks(bytes.substr(at, end - at));
    at = end + 1;
    if (is_name_in_memory(line)) return true;
    if (line.empty() || line[0] == '%' || line[0] == ';') continue;
    const SiemensLineStart start = read_siemens_start(line);
    (start.number.empty() ? others : blocks) += 1;
    has_mark = has_mark || is_mark_in(line);
  }
  return has_mark && blocks > 2 && blocks > 4 * others;
}

ProgramFacts run_siemens(const ProgramInput& input) {
  const ProgramText text(input.path.source, input.path.statements);
  SiemensRunner runner(input, has_tool_code(text));
  SiemensRun run(input, text, runner);
  run.run_start(input.options.setup.start);
  find_text_outside(text, runner);
  find_other_programs(text, input.path.statements, runner);
  run.run();
  ProgramFacts facts;
  facts.unit_line = runner.unit_line();
  facts.unit_word = runner.unit_word();
  facts.offset_line = runner.offset_line();
  facts.end_line = run.end_line();
  facts.loading_line = runner.loading_line();
  facts.other = find_blocks_behind(text, input.motion.has_run(), run.may_jump());
  facts.error = runner.error();
  return facts;
}

}  // namespace gouge

#include "postproc/gcode/reading/read_gcode.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lib/base/number_text.h"
#include "postproc/gcode/reading/assume_program.h"
#include "postproc/gcode/reading/program_run.h"

namespace gouge {
namespace {

constexpr std::size_t kLongestProgram = (std::size_t{1} << 32U) - 2;  // a SmallIndex can count its bytes
constexpr std::size_t kLinesOfRecognition = 300;
constexpr std::string_view kMarkOfBytes = "\xef\xbb\xbf";

bool is_forbidden(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return (byte < 0x20 && c != '\n' && c != '\t' && c != '\r') || byte == 0x7f;
}

/// Returns why the bytes are no text of blocks: a control character, or a carriage return within a line.
std::optional<Diagnostic> find_wrong_byte(const std::string& file, std::string_view bytes) {
  std::size_t line = 1;
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    const char c = bytes[at];
    if (c == '\n') ++line;
    const bool is_alone = c == '\r' && at + 1 < bytes.size() && bytes[at + 1] != '\n' && bytes[at + 1] != '\r';
    if (!is_forbidden(c) && !is_alone) continue;
    return make_error("path-binary",
                      "byte " + std::to_string(static_cast<unsigned char>(c)) +
                          " is no text of a program; expected lines that end with LF or CR LF",
                      file, line);
  }
  return std::nullopt;
}

std::optional<Diagnostic> find_unreadable_program(const std::string& file, std::string_view bytes) {
  if (bytes.empty()) return make_error("path-empty", "the file is empty; expected a program", file);
  if (bytes.size() > kLongestProgram)
    return make_error("path-too-long",
                      "the file has " + std::to_string(bytes.size()) + " bytes; expected fewer than 4 GiB", file);
  return find_wrong_byte(file, bytes);
}

/// Returns whether a code that applies a tool length stands in the text. Comments count too: then a length must be given
/// that would not be needed otherwise.
bool may_apply_lengths(std::string_view text) {
  for (const std::string_view code : {"G43", "g43", "G 43", "g 43", "G44", "g44", "G043", "G234", "g234", "#", "G4["})
    if (text.find(code) != std::string_view::npos) return true;
  return false;
}

Result<const ControlTable*> control_of(const GcodeOptions& options, const std::string& file) {
  const std::string& id = options.setup.control;
  if (id.empty())
    return make_error("gcode-control",
                      "the file is a program of a machine's control, and nothing states which; expected --control " +
                          control_names() + ", or \"program\" in the control of the machine file",
                      file);
  if (const ControlTable* const control = control_called(id)) return control;
  return make_error("gcode-control", "the control is '" + id + "'; expected " + control_names(), file);
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

void name_first_tool(const std::string& name, Toolpath& path) {
  if (name.empty()) return;
  const auto is_unnamed = [](const Move& move) { return move.tool == kNone; };
  const auto first = std::ranges::find_if(path.moves, is_unnamed);
  if (first == path.moves.end()) return;
  PathTool tool;
  tool.name = name;
  tool.line = first->line;
  for (Move& move : path.moves)
    if (is_unnamed(move)) move.tool = path.tools.size();
  path.tools.push_back(std::move(tool));
}

bool has_checked_move(const Toolpath& path) {
  return std::ranges::any_of(path.moves, [](const Move& move) { return move.not_checked_reason.empty(); });
}

}  // namespace

bool is_gcode(std::string_view bytes) {
  if (bytes.starts_with(kMarkOfBytes)) bytes.remove_prefix(kMarkOfBytes.size());
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

ReadOutcome read_gcode(const std::string& file_name, SourceText bytes, const GcodeOptions& options,
                       const ProgressCall& progress) {
  ReadOutcome outcome;
  if (auto error = find_unreadable_program(file_name, bytes)) return {std::nullopt, {std::move(*error)}};
  const Result<const ControlTable*> control = control_of(options, file_name);
  if (!control) return {std::nullopt, {control.error()}};
  const ControlTable& table = **control;
  if (options.setup.machine) {
    if (const std::string unfit = describe_unfit(*options.setup.machine); !unfit.empty())
      return {std::nullopt, {make_error("gcode-machine", unfit, file_name)}};
  }
  Toolpath path;
  path.file = file_name;
  path.source = std::move(bytes);
  path.dialect = "gcode";
  path.harmless_words = options.harmless_words;
  path.unit = options.unit.value_or(LengthUnit::mm);
  path.is_unit_stated = options.unit.has_value();
  const std::string_view all = path.source;
  add_lines(all, path.statements);

  PathBuilder builder(path);
  const CodeIndex index(table, options.harmless_words);
  ProgramMotion motion(builder, options.setup);
  BlockRunner runner(index, options.setup, options.unit, motion, path);
  const ProgramText text(all, path.statements);
  if (text.size() == 0) return {std::nullopt, {make_error("path-no-motion", "holds no block", file_name)}};
  if (!may_apply_lengths(all)) motion.omit_lengths();
  ProgramRun run(table, options.setup, text, runner, motion);
  run.run_start(table.start);
  run.run_start(options.setup.start);
  find_blocks_outside(text, table, runner);
  run.run(progress, file_name);
  motion.finish();
  if (runner.error()) return {std::nullopt, {*runner.error()}};
  if (!has_checked_move(path)) {
    const std::string reason = path.moves.empty() ? "" : ": " + std::string(path.moves.front().not_checked_reason);
    return {std::nullopt,
            {make_error("path-no-motion", "holds no motion whose place is known" + reason, file_name,
                        path.moves.empty() ? std::size_t{0} : std::size_t{path.moves.front().line})}};
  }
  name_first_tool(options.unnamed_tool, path);
  const ProgramFacts facts{runner.unit_line(), runner.offset_line(),
                           run.end_line() > 0    ? run.end_line()
                           : text.has_end_mark() ? text.number(text.end())
                                                 : 0,
                           options.unit.has_value(), options.setup.is_control_stated};
  path.assumptions = assume_program(path, table, options.setup, motion, facts);
  outcome.toolpath = std::move(path);
  return outcome;
}

}  // namespace gouge

#include "postproc/gcode/reading/read_gcode.h"

#include <algorithm>
#include <array>
#include <utility>

#include "lib/base/file_kind.h"
#include "lib/base/number_text.h"
#include "postproc/gcode/heidenhain/read_heidenhain.h"
#include "postproc/gcode/iso/read_iso.h"
#include "postproc/gcode/language/control_tables.h"
#include "postproc/gcode/reading/assume_program.h"
#include "postproc/gcode/running/program_text.h"
#include "postproc/gcode/siemens/read_siemens.h"

namespace gouge {
namespace {

constexpr std::string_view kHeidenhain = "heidenhain";

constexpr std::size_t kLongestProgram = (std::size_t{1} << 32U) - 2;  // a SmallIndex can count its bytes

bool is_forbidden(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return (byte < 0x20 && c != '\n' && c != '\t' && c != '\r') || byte == 0x7f;
}

/// Returns whether no byte is forbidden and no line ends with CR. Without a branch for each byte.
bool is_plain(std::string_view bytes) {
  unsigned char found = 0;
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    const bool is_low = byte < 0x20, is_blank = byte == '\n' || byte == '\t', is_high = byte == 0x7f;
    found |= static_cast<unsigned char>((is_low & !is_blank) | is_high);
  }
  return found == 0;
}

/// Returns why the bytes are no text of blocks: a control character, or a carriage return within a line, but for the
/// comments of some languages.
std::optional<Diagnostic> find_wrong_byte(const std::string& file, std::string_view bytes, bool may_return_in_comment) {
  if (is_plain(bytes)) return std::nullopt;
  std::size_t line = 1;
  bool is_comment = false;
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    const char c = bytes[at];
    if (c == '\n') ++line;
    is_comment = c != '\n' && (is_comment || c == ';');
    const bool is_alone = c == '\r' && !(may_return_in_comment && is_comment) && at + 1 < bytes.size() &&
                          bytes[at + 1] != '\n' && bytes[at + 1] != '\r';
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
  if (const std::string stand_in = describe_stand_in(file, bytes); !stand_in.empty())
    return make_error("path-not-cl-data", stand_in, file);
  if (bytes.size() > kLongestProgram)
    return make_error("path-too-long",
                      "the file has " + std::to_string(bytes.size()) + " bytes; expected fewer than 4 GiB", file);
  return std::nullopt;
}

/// Returns the choice of a control for a program. It names the control whose words the program has, if only that control
/// reads them.
std::string expected_control(std::string_view bytes) {
  if (is_siemens_program(bytes)) return "--control siemens, because the program has words of Siemens 840D";
  return "--control " + language_names();
}

/// Completes the control of the setup. Only programs of Heidenhain begin with BEGIN PGM.
ProgramSetup with_control(ProgramSetup setup, std::string_view bytes) {
  setup.is_control_of_program = setup.control.empty() && is_heidenhain_program(bytes);
  if (setup.is_control_of_program) setup.control = kHeidenhain;
  return setup;
}

Result<const ProgramLanguage*> language_of(const std::string& id, const std::string& file, std::string_view bytes) {
  if (id.empty())
    return make_error("gcode-control",
                      "the file is a program of a machine's control, and nothing states which; expected " +
                          expected_control(bytes) + ", or \"program\" in the control of the machine file",
                      file);
  for (const ProgramLanguage& language : all_languages())
    if (language.id == id) return &language;
  return make_error("gcode-control", "the control is '" + id + "'; expected " + language_names(), file);
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

/// Notes blocks that the control does not reach: the user may take them for checked.
void note_blocks_not_run(const std::vector<bool>& has_run, Toolpath& path) {
  std::size_t count = 0, first_line = 0;
  for (std::size_t i = 0; i < path.statements.size(); ++i) {
    if (has_run[i]) continue;
    const SourceStatement& one = path.statements[i];
    const std::string_view line =
        trim_blanks(std::string_view(path.source).substr(one.first_byte, one.last_byte - one.first_byte));
    const bool is_block = std::string_view("%;(*").find(line[0]) == std::string_view::npos;
    if (!is_block) continue;
    if (count++ == 0) first_line = one.line;
  }
  if (count == 0) return;
  path.notes.push_back(make_note("gcode-not-run",
                                 count_text(count, "block") + (count == 1 ? " does" : " do") + " not run and " +
                                     (count == 1 ? "is" : "are") +
                                     " not checked: behind the end of the program, jumped over, or never called",
                                 path.file, first_line));
}

/// Finds a word that is not understood in the blocks at the start, which are no lines of the program.
std::optional<Diagnostic> find_wrong_start(const Toolpath& path, const std::string& start) {
  constexpr std::string_view kOfStart = "line 0: ";
  const auto wrong = path.words_not_understood.lower_bound(std::string(kOfStart));
  if (wrong == path.words_not_understood.end() || !wrong->first.starts_with(kOfStart)) return std::nullopt;
  return make_error("usage", "--start, or start of the machine: '" + std::string(trim_blanks(start)) +
                                 "': " + wrong->first.substr(kOfStart.size()));
}

/// Finds a unit of the command line that the program, or the blocks in force at its start, contradict. Otherwise the
/// option would have no effect, and the user would not see it.
std::optional<Diagnostic> find_other_unit(const Toolpath& path, const GcodeOptions& options,
                                          const ProgramFacts& facts) {
  if (!options.unit || *options.unit == path.unit) return std::nullopt;
  const std::string unit = path.unit == LengthUnit::inch ? "inches" : "mm";
  constexpr const char* kOther = ", the command line another unit; expected --path-units only for ";
  if (facts.unit_line == 0)
    return make_error("path-unit",
                      "the blocks in force at the start (--start, or start of the machine) state " + unit + kOther +
                          "programs whose unit nothing states",
                      path.file);
  return make_error("path-unit",
                    "the program states " + unit + " (" + facts.unit_word + ")" + kOther + "files that state none",
                    path.file, facts.unit_line);
}

/// Describes why no motion of a program can be checked: the reason of its first move, else its last note.
Diagnostic describe_no_motion(const Toolpath& path, const ProgramMotion& motion) {
  std::string reason = "no block moves an axis";
  std::size_t line = 0;
  if (!path.moves.empty()) {
    reason = path.moves.front().not_checked_reason;
    line = path.moves.front().line;
  } else if (!path.notes.empty()) {
    reason = path.notes.back().message;
    line = path.notes.back().line;
  }
  std::vector<std::string> words = words_by_line(path);
  if (words.size() > 1) {
    words.erase(words.begin());  // the first one is the reason
    reason += "; also not understood: " + listed(words);
  }
  if (motion.is_rest_unknown())
    reason += "; correct the program, or state a word that neither moves nor changes anything with --harmless-word";
  return make_error("path-no-motion", "holds no motion that can be checked: " + reason, path.file, line);
}

}  // namespace

std::span<const ProgramLanguage> all_languages() {
  static const std::array<ProgramLanguage, 5> languages = {{
      {linuxcnc_table().id, linuxcnc_table().title,
       [](const ProgramInput& input) { return run_iso(linuxcnc_table(), input); }},
      {haas_table().id, haas_table().title, [](const ProgramInput& input) { return run_iso(haas_table(), input); }},
      {fanuc_table().id, fanuc_table().title, [](const ProgramInput& input) { return run_iso(fanuc_table(), input); }},
      {"siemens", "Siemens 840D", run_siemens},
      {kHeidenhain, "Heidenhain Klartext", run_heidenhain, true},
  }};
  return languages;
}

std::string language_names() {
  std::vector<std::string> names;
  for (const ProgramLanguage& language : all_languages()) names.emplace_back(language.id);
  return listed(names, " or ");
}

bool is_gcode(std::string_view bytes) {
  return is_heidenhain_program(bytes) || is_iso_program(bytes) || is_siemens_program(bytes);
}

ReadOutcome read_gcode(const std::string& file_name, SourceText bytes, const GcodeOptions& stated,
                       const ProgressCall& progress) {
  ReadOutcome outcome;
  if (auto error = find_unreadable_program(file_name, bytes)) return {std::nullopt, {std::move(*error)}};
  GcodeOptions options = stated;
  options.setup = with_control(std::move(options.setup), bytes);
  const Result<const ProgramLanguage*> language = language_of(options.setup.control, file_name, bytes);
  if (!language) return {std::nullopt, {language.error()}};
  if ((*language)->id != kHeidenhain && is_heidenhain_program(bytes))
    return {std::nullopt,
            {make_error("gcode-control",
                        "begins with BEGIN PGM, as programs of Heidenhain Klartext do, and the control is '" +
                            std::string((*language)->id) + "'; expected --control heidenhain",
                        file_name)}};
  if (auto error = find_wrong_byte(file_name, bytes, (*language)->may_return_in_comment))
    return {std::nullopt, {std::move(*error)}};
  if (options.setup.machine) {
    if (const std::string unfit = describe_unfit(*options.setup.machine); !unfit.empty())
      return {std::nullopt, {make_error("gcode-machine", unfit, file_name)}};
  }
  Toolpath path;
  path.file = file_name;
  path.source = std::move(bytes);
  path.dialect = kProgramDialect;
  path.harmless_words = options.harmless_words;
  path.unit = options.unit.value_or(LengthUnit::mm);
  path.is_unit_stated = options.unit.has_value();
  add_lines(path.source, path.statements);
  if (path.statements.empty()) return {std::nullopt, {make_error("path-no-motion", "holds no block", file_name)}};
  PathBuilder builder(path);
  ProgramMotion motion(builder, options.setup);
  const ProgramFacts facts = (*language)->run({options, path, motion, progress});
  motion.finish();
  if (facts.error) return {std::nullopt, {*facts.error}};
  if (auto error = find_wrong_start(path, options.setup.start)) return {std::nullopt, {std::move(*error)}};
  if (auto error = find_other_unit(path, options, facts)) return {std::nullopt, {std::move(*error)}};
  if (!motion.is_rest_unknown()) note_blocks_not_run(motion.has_run(), path);
  if (!has_checked_move(path)) return {std::nullopt, {describe_no_motion(path, motion)}};
  const bool is_in_part = options.setup.zero && options.setup.offsets.contains(motion.part_offset());
  if (!is_in_part) path.work_offset = motion.part_offset();
  name_first_tool(options.unnamed_tool, path);
  path.assumptions = assume_program(path, (*language)->title, options, motion, facts);
  outcome.toolpath = std::move(path);
  return outcome;
}

}  // namespace gouge

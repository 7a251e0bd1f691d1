#include "postproc/cldata/reading/read_cl_data.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "lib/base/file_kind.h"
#include "lib/base/stage.h"
#include "lib/base/units.h"
#include "postproc/cldata/interpreting/interpreter.h"
#include "postproc/cldata/language/dialect.h"
#include "postproc/cldata/language/text.h"
#include "postproc/cldata/language/words.h"
#include "postproc/cldata/lexing/read_ahead.h"
#include "postproc/cldata/reading/assume_file.h"
#include "postproc/cldata/reading/foreign_file.h"
#include "postproc/cldata/reading/unit_guess.h"

namespace gouge {
namespace {

constexpr std::size_t kShortestPosition = std::string_view("GOTO/1,1,1").size();
constexpr std::size_t kLongestFile = (std::size_t{1} << 32U) - 2;  // a SmallIndex can count its bytes
constexpr const char* kExpected =
    "expected APT CL data, an NX CLSF, a binary NCCS or a Mastercam NCI file, or a program of a machine with --control";

// Bytes that do not occur in text: control characters except line ends, tabs and other blanks.
constexpr std::array<bool, 256> kIsControl = [] {
  std::array<bool, 256> is_control{};
  for (std::size_t byte = 0; byte < 0x20; ++byte) {
    const char c = static_cast<char>(byte);
    is_control[byte] = c != '\n' && !is_blank(c);
  }
  is_control[0x7f] = true;
  return is_control;
}();

bool is_control(char c) { return kIsControl[static_cast<unsigned char>(c)]; }

// Returns the place of the first control character, or the end. It works in sections, because a loop that cannot end
// early examines several bytes at once.
std::size_t find_control(std::string_view bytes) {
  constexpr std::size_t kStretch = 4096;
  for (std::size_t at = 0; at < bytes.size(); at += kStretch) {
    const std::string_view section = bytes.substr(at, kStretch);
    unsigned has_control = 0;
    for (const char c : section) has_control |= static_cast<unsigned>(is_control(c));
    if (has_control == 0) continue;
    return at + static_cast<std::size_t>(std::find_if(section.begin(), section.end(), is_control) - section.begin());
  }
  return bytes.size();
}

// Returns whether the text has only printable characters of ASCII, tabs, and lines that end with LF or CR LF. Most files
// do, and one pass finds out. It works in sections too, with single bytes, so that the compiler examines many at once.
bool is_plain(std::string_view bytes) {
  constexpr std::size_t kStretch = 4096;
  using Byte = unsigned char;
  const auto is_between = [](Byte byte, Byte first, Byte last) {
    return static_cast<Byte>(byte >= first && byte <= last);
  };
  for (std::size_t at = 0; at < bytes.size(); at += kStretch) {
    const std::string_view section = bytes.substr(at, kStretch);
    Byte is_all_plain = 1, has_return = 0;
    for (const char c : section) {
      const auto byte = static_cast<Byte>(c);
      const Byte is_return = is_between(byte, '\r', '\r');
      is_all_plain &= static_cast<Byte>(is_between(byte, ' ', '~') | is_between(byte, '\t', '\n') | is_return);
      has_return |= is_return;
    }
    if (is_all_plain == 0) return false;
    if (has_return == 0) continue;
    for (std::size_t i = section.find('\r'); i < section.size(); i = section.find('\r', i + 1)) {
      if (at + i + 1 < bytes.size() && bytes[at + i + 1] != '\n') return false;
    }
  }
  return true;
}

bool is_break(char c) { return c == '\f' || c == '\v' || c == '\x1a'; }

bool has_break(std::string_view section, char next) {
  const auto is_odd = [](char c, char following) {
    return static_cast<unsigned>(is_break(c)) | static_cast<unsigned>(c == '\r' && following != '\n');
  };
  unsigned has = is_odd(section.back(), next);
  for (std::size_t i = 0; i + 1 < section.size(); ++i) has |= is_odd(section[i], section[i + 1]);
  return has != 0;
}

// Finds a carriage return alone, a page break or an end-of-file character between two texts of one line, or the end.
// Readers differ there: some continue the line, others begin a new one. It works in sections too.
std::size_t find_break(std::string_view bytes) {
  constexpr std::size_t kStretch = 4096;
  const auto skip_blanks = [&](std::size_t at) {
    while (at < bytes.size() && is_blank(bytes[at])) ++at;
    return at;
  };
  std::size_t text = skip_blanks(0), looked_at = 0;  // the first text of the line, and the end of the examined bytes
  for (std::size_t begin = 0; begin < bytes.size(); begin += kStretch) {
    const std::size_t end = std::min(begin + kStretch, bytes.size());
    if (!has_break(bytes.substr(begin, end - begin), end < bytes.size() ? bytes[end] : '\n')) continue;
    for (std::size_t at = std::max(begin, looked_at); at < end; ++at) {
      if (!is_blank(bytes[at]) || bytes[at] == ' ' || bytes[at] == '\t') continue;
      const std::size_t line_end = bytes.substr(looked_at, at - looked_at).rfind('\n');
      if (line_end != std::string_view::npos) text = skip_blanks(looked_at + line_end + 1);
      const std::size_t after = skip_blanks(at);
      if (text < at && after < bytes.size() && bytes[after] != '\n') return at;
      at = looked_at = after - 1;
    }
  }
  return bytes.size();
}

// Returns whether a text begins a statement: with a known word.
bool begins_statement(std::string_view text) {
  text = trim(text.substr(0, text.find('\n')));
  const auto letters = static_cast<std::size_t>(std::ranges::find_if_not(text, is_letter) - text.begin());
  return letters > 0 && find_word(text.substr(0, letters)) != Word::unknown;
}

// Returns the place of a line separator of Unicode (NEL, LS, PS) within a line, or the end. Byte 133 alone is NEL in
// one code page and a character in others, so it counts only before a statement.
std::size_t find_separator(std::string_view bytes) {
  constexpr char kNel = '\x85', kLs = '\xa8', kPs = '\xa9';
  for (std::size_t at = bytes.find_first_of("\x85\xa8\xa9"); at != std::string_view::npos;
       at = bytes.find_first_of("\x85\xa8\xa9", at + 1)) {
    const bool is_nel = bytes[at] == kNel && at > 0 && bytes[at - 1] == '\xc2';
    const bool is_separator = (bytes[at] == kLs || bytes[at] == kPs) && bytes.substr(0, at).ends_with("\xe2\x80");
    const std::string_view rest = bytes.substr(at + 1);
    const bool is_within = !trim(rest.substr(0, rest.find('\n'))).empty();
    const bool is_alone = bytes[at] == kNel && !is_nel && begins_statement(rest);
    if (((is_nel || is_separator) && is_within) || is_alone) return at;
  }
  return bytes.size();
}

std::size_t line_of(std::string_view bytes, std::size_t at) {
  const std::string_view before = bytes.substr(0, at);
  return static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n')) + 1;
}

struct LineCount {
  std::size_t with_text = 0;
  std::size_t with_position = 0;  // lines that look like GOTO/x,y,z
};

LineCount count_lines(std::string_view bytes) {
  LineCount count;
  for (std::size_t at = 0; at < bytes.size();) {
    const std::size_t end = std::min(bytes.find('\n', at), bytes.size());
    if (end > at) ++count.with_text;
    if (end >= at + kShortestPosition && (bytes[at] == 'G' || bytes[at] == 'g')) ++count.with_position;
    at = end + 1;
  }
  return count;
}

std::optional<Diagnostic> find_unreadable(const std::string& file, std::string_view bytes, const Dialect& dialect,
                                          bool is_dialect_given) {
  if (bytes.empty()) return make_error("path-empty", std::string("the file is empty; ") + kExpected, file);
  if (bytes.size() > kLongestFile) {
    return make_error(
        "path-too-long",
        "the file has " + std::to_string(bytes.size()) + " bytes; expected fewer than 4 GiB: divide it by operations",
        file);
  }
  // An archive may hold words of a dialect, if they are not compressed.
  const std::optional<FileKind> kind = recognise_file({}, bytes);
  if ((dialect.is_fallback && !is_dialect_given) || (kind && kind->family == FileFamily::archive)) {
    if (auto sentence = describe_foreign(file, bytes))
      return make_error("path-not-cl-data", std::move(*sentence), file);
  }
  if (dialect.is_binary || is_plain(bytes)) return std::nullopt;
  if (const std::size_t at = find_separator(bytes); at < bytes.size()) {
    return make_error("path-line-end",
                      "a line separator of Unicode (NEL, LS or PS) stands within this line; expected lines that end "
                      "with LF or CR LF: save the file so",
                      file, line_of(bytes, at));
  }
  const std::size_t control = find_control(bytes);
  const std::size_t amid = control == bytes.size() ? find_break(bytes) : control;
  if (amid == bytes.size()) return std::nullopt;
  if (amid != control) {
    return make_error("path-line-end",
                      "byte " + std::to_string(static_cast<unsigned char>(bytes[amid])) +
                          (bytes[amid] == '\r' ? " (a carriage return alone)" : " (a page or file end)") +
                          " stands within this line; expected lines that end with LF or CR LF: save the file so",
                      file, line_of(bytes, amid));
  }
  return make_error("path-binary",
                    "is not text: byte " + std::to_string(static_cast<unsigned char>(bytes[control])) +
                        " at position " + std::to_string(control) + "; " + kExpected,
                    file, line_of(bytes, control));
}

std::optional<Diagnostic> find_other_unit(const UnitGuess& guess, const ReadOptions& options, const std::string& file) {
  if (guess.source != UnitGuess::Source::stated || !options.unit || *options.unit == guess.unit) return std::nullopt;
  const std::string unit = guess.unit == LengthUnit::inch ? "inches" : "mm";
  return make_error("path-unit",
                    "the file states " + unit +
                        ", the command line another unit; expected --path-units only for files that state none",
                    file, guess.line);
}

std::optional<Diagnostic> find_two_units(const UnitGuess& guess, const FeedUnits& feeds, const std::string& file) {
  if (guess.source == UnitGuess::Source::stated || guess.source == UnitGuess::Source::option || !feeds.are_two())
    return std::nullopt;
  return make_error("path-unit",
                    "the file states no unit, and its feeds are in two: in mm in line " +
                        std::to_string(feeds.in_mm()) + ", in inches in line " + std::to_string(feeds.in_inches()) +
                        "; say which one positions are in: --path-units mm or inch",
                    file, std::max(feeds.in_mm(), feeds.in_inches()));
}

// Contradicts a unit that the user states if all feeds of the file are in the other one.
void compare_with_feeds(const UnitGuess& guess, const FeedUnits& feeds, Assumptions& facts) {
  const bool is_inch = guess.unit == LengthUnit::inch;
  const std::size_t line = is_inch ? feeds.in_mm() : feeds.in_inches();
  const auto fact = std::ranges::find(facts, Subject::path_unit, &Assumption::subject);
  if (guess.source != UnitGuess::Source::option || feeds.are_two() || line == 0 || fact == facts.end()) return;
  fact->basis = Basis::contradicted;
  fact->evidence = std::string("--path-units states ") + (is_inch ? "inches" : "mm") + ", and all feeds are in " +
                   (is_inch ? "mm" : "inches") + ", the first in line " + std::to_string(line);
  fact->line = line;
  fact->remedy = "correct --path-units, or state that it is right with --assume path-unit";
}

// Returns whether a move of the file is understood. Statements that are not understood but may be motions also give
// moves.
bool has_motion(const Toolpath& path) {
  return std::any_of(path.moves.begin(), path.moves.end(),
                     [](const Move& move) { return kind_of(move.not_checked_reason) != ReasonKind::may_be_unread; });
}

Diagnostic no_motion(const Toolpath& path, const Dialect& dialect) {
  std::string message = std::string("holds no position; ") + kExpected;
  if (!path.moves.empty()) {
    const std::size_t count = path.moves.size();
    message = "holds no position that is understood, and " + std::to_string(count) +
              (count == 1 ? " statement" : " statements") + " that may be motions, the first in line " +
              std::to_string(path.moves.front().line) + "; " + kExpected;
  }
  if (!dialect.no_position.empty()) {
    message = dialect.no_position;
  } else if (!path.statements.empty()) {
    const SourceStatement& first = path.statements.front();
    const std::string_view all = path.source;
    message += "; the first line is " + quoted_text(all.substr(first.first_byte, first.last_byte - first.first_byte));
  }
  return make_error("path-no-motion", std::move(message), path.file);
}

UnitGuess unit_of(std::string_view bytes, OpenStatements open, const ReadOptions& options) {
  const UnitGuess guess = find_unit(bytes, open);
  if (guess.source == UnitGuess::Source::stated || !options.unit) return guess;
  return {*options.unit, UnitGuess::Source::option, {}, 0};
}

// Gives the name to moves without a tool. Bare lists of positions name no tool at all, other files none before their
// first tool change.
void name_unnamed_tool(const std::string& name, Toolpath& path) {
  std::size_t moves = 0, first_line = 0;
  for (Move& move : path.moves) {
    if (move.tool != kNone) continue;
    if (moves++ == 0) first_line = move.line;
    move.tool = path.tools.size();
  }
  if (moves == 0) return;
  PathTool tool;
  tool.name = name;
  tool.line = first_line;
  path.tools.push_back(std::move(tool));
  path.notes.push_back(make_note(
      "path-unnamed-tool", std::to_string(moves) + " moves for which the file names no tool: \"" + name + "\" as asked",
      path.file, first_line));
}

// Reports the last line. A file that was cut off ends within its last line, which is then misread.
void report_last_line(std::string_view bytes, const Dialect& dialect, Diagnostics& errors) {
  const bool is_ended = bytes.empty() || bytes.back() == '\n' || bytes.back() == '\r';
  if (is_ended || dialect.is_binary) return;
  const auto last = static_cast<std::size_t>(std::count(bytes.begin(), bytes.end(), '\n')) + 1;
  for (Diagnostic& error : errors) {
    if (error.line == last) error.message += "; this is the last line, without an end: the file may be cut off";
  }
}

// Opens the statements of a file. A thread reads those of a long file ahead, if there is one.
std::unique_ptr<StatementSource> open_statements(std::string_view bytes, OpenStatements open) {
  constexpr std::size_t kLongFile = std::size_t{1} << 20U;
  auto source = open(bytes, 0, 1);
  return bytes.size() < kLongFile || usable_threads() < 2 ? std::move(source) : read_ahead(std::move(source));
}

}  // namespace

ReadOutcome read_cl_data(const std::string& file_name, SourceText bytes, const Dialect& dialect, OpenStatements open,
                         const ReadOptions& options, const ProgressCall& progress) {
  ReadOutcome outcome;
  if (auto error = find_unreadable(file_name, bytes, dialect, options.dialect.has_value())) {
    outcome.errors.push_back(std::move(*error));
    return outcome;
  }
  Toolpath path;
  path.file = file_name;
  path.source = std::move(bytes);
  const UnitGuess guess = unit_of(path.source, open, options);
  path.dialect = dialect.id;
  path.harmless_words = options.harmless_words;
  path.retract_plane_mm = options.retract_plane_mm;
  path.unit = guess.unit;
  path.is_unit_stated = guess.source == UnitGuess::Source::stated;

  const LineCount lines = count_lines(path.source);
  path.statements.reserve(lines.with_text);
  path.moves.reserve(lines.with_position);
  const auto records = options.keeps_origins ? std::make_shared<MotionRecords>() : nullptr;
  if (records) records->of_move.reserve(lines.with_position);
  Interpreter interpreter(path, dialect, guess.unit, records.get());
  if (options.is_cutcom_centre) interpreter.set_cutter_centre();
  const auto source = open_statements(path.source, open);
  Statement statement;
  Stage stage(progress, "reading " + file_name, lines.with_text);
  for (std::size_t i = 0; !interpreter.is_beyond_cutoff() && source->next(statement); ++i) {
    stage.pass(i);
    interpreter.take(statement);
  }
  if (!interpreter.is_beyond_cutoff()) interpreter.finish();
  outcome.errors = interpreter.take_errors();
  report_last_line(path.source, dialect, outcome.errors);
  if (outcome.errors.empty() && !has_motion(path)) outcome.errors.push_back(no_motion(path, dialect));
  if (!outcome.errors.empty()) return outcome;
  if (auto error = find_two_units(guess, interpreter.feed_units(), file_name)) {
    outcome.errors.push_back(std::move(*error));
    return outcome;
  }
  if (auto error = find_other_unit(guess, options, file_name)) {
    outcome.errors.push_back(std::move(*error));
    return outcome;
  }
  const FileFacts& facts = interpreter.facts();
  path.assumptions = assume_file(path, guess, dialect, options.dialect.has_value(), facts);
  compare_with_feeds(guess, interpreter.feed_units(), path.assumptions);
  path.has_turned_frame = facts.has_turned_frame;
  path.smoothing_line = facts.smoothing_line;
  path.smoothing_mm = facts.smoothing_mm;
  path.joint_law_line = facts.joint_law_line;
  path.origins = records;
  if (!options.unnamed_tool.empty()) name_unnamed_tool(options.unnamed_tool, path);
  outcome.toolpath = std::move(path);
  return outcome;
}

}  // namespace gouge

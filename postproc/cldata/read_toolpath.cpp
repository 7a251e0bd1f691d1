#include "postproc/cldata/read_toolpath.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "postproc/cldata/foreign_file.h"
#include "postproc/cldata/interpreter.h"
#include "postproc/cldata/statement_reader.h"
#include "postproc/cldata/text.h"
#include "postproc/cldata/unit_guess.h"

namespace gouge {
namespace {

constexpr std::size_t kUsualBytesOfLine = 32;
constexpr const char* kExpected = "expected APT CL data, an NX CLSF, a binary NCCS or a Mastercam NCI file";

bool is_control(char c) {
  const unsigned byte = static_cast<unsigned char>(c);
  return (byte < 0x20 && c != '\n' && !is_blank(c)) || byte == 0x7f;
}

std::optional<Diagnostic> find_unreadable(const std::string& file, std::string_view bytes,
                                          const Dialect& dialect, bool is_dialect_given) {
  if (bytes.empty()) return make_error("path-empty", std::string("the file is empty; ") + kExpected, file);
  if (dialect.kind == DialectKind::apt && !is_dialect_given) {
    if (auto sentence = describe_foreign(bytes))
      return make_error("path-not-cl-data", std::move(*sentence), file);
  }
  if (dialect.kind == DialectKind::nccs_binary) return std::nullopt;
  const auto control = std::find_if(bytes.begin(), bytes.end(), is_control);
  if (control == bytes.end()) return std::nullopt;
  const auto line = static_cast<std::size_t>(std::count(bytes.begin(), control, '\n')) + 1;
  return make_error("path-binary",
                    "is not text: byte " + std::to_string(static_cast<unsigned char>(*control)) +
                        " at position " + std::to_string(control - bytes.begin()) + "; " + kExpected,
                    file, line);
}

std::optional<Diagnostic> note_unit(const UnitGuess& guess, const ReadOptions& options, Toolpath& path) {
  const std::string unit = guess.unit == LengthUnit::inch ? "inches" : "mm";
  const std::string taken = "the file states no unit; taken as " + unit;
  switch (guess.source) {
    case UnitGuess::Source::stated:
      if (!options.unit || *options.unit == guess.unit) return std::nullopt;
      return make_error("path-unit",
                        "the file states " + unit +
                            ", the command line another unit; expected --path-units "
                            "only for files that state none",
                        path.file);
    case UnitGuess::Source::option:
      path.notes.push_back(make_note("path-unit", taken + " as asked", path.file));
      break;
    case UnitGuess::Source::feed_word:
      path.notes.push_back(make_note("path-unit", taken + " from the feed words (MMPM, IPM)", path.file));
      break;
    case UnitGuess::Source::dialect:
      path.notes.push_back(
          make_note("path-unit", taken + ", which CATIA writes unless it says otherwise", path.file));
      break;
    case UnitGuess::Source::assumed:
      path.notes.push_back(
          make_warning("path-unit", taken + " for want of evidence; say --path-units mm or inch", path.file));
  }
  return std::nullopt;
}

Diagnostic no_motion(const Toolpath& path, const Dialect& dialect) {
  std::string message = "holds no position; expected GOTO statements of APT CL data or an NX CLSF";
  if (dialect.kind == DialectKind::nccs_binary) {
    message = "is a binary NCCS file without a position; expected motion records";
  } else if (!path.statements.empty()) {
    const SourceStatement& first = path.statements.front();
    const std::string_view all = path.source;
    message += "; the first line is " +
               quoted_text(all.substr(first.first_byte, first.last_byte - first.first_byte));
  }
  return make_error("path-no-motion", std::move(message), path.file);
}

UnitGuess unit_of(std::string_view bytes, const Dialect& dialect, const ReadOptions& options) {
  const UnitGuess guess = find_unit(bytes, dialect);
  if (guess.source == UnitGuess::Source::stated || !options.unit) return guess;
  return {*options.unit, UnitGuess::Source::option};
}

}  // namespace

ReadOutcome read_toolpath(const std::string& file_name, std::string bytes, const ReadOptions& options) {
  ReadOutcome outcome;
  const Dialect dialect = options.dialect.value_or(recognise_dialect(bytes));
  if (auto error = find_unreadable(file_name, bytes, dialect, options.dialect.has_value())) {
    outcome.errors.push_back(std::move(*error));
    return outcome;
  }
  Toolpath path;
  path.file = file_name;
  path.source = std::move(bytes);
  const UnitGuess guess = unit_of(path.source, dialect, options);
  path.dialect = dialect.id;
  path.unit = guess.unit;
  path.is_unit_stated = guess.source == UnitGuess::Source::stated;

  path.statements.reserve(path.source.size() / kUsualBytesOfLine);
  path.moves.reserve(path.source.size() / kUsualBytesOfLine);
  Interpreter interpreter(path, dialect, guess.unit, nullptr);
  if (options.is_cutcom_centre) interpreter.set_cutter_centre();
  StatementReader reader(path.source, dialect.kind);
  Statement statement;
  while (!interpreter.is_hopeless() && reader.next(statement)) interpreter.take(statement);
  if (!interpreter.is_hopeless()) interpreter.finish();
  outcome.errors = interpreter.take_errors();
  if (outcome.errors.empty() && path.moves.empty()) outcome.errors.push_back(no_motion(path, dialect));
  if (!outcome.errors.empty()) return outcome;
  if (auto error = note_unit(guess, options, path)) {
    outcome.errors.push_back(std::move(*error));
    return outcome;
  }
  outcome.toolpath = std::move(path);
  return outcome;
}

}  // namespace gouge

#include "postproc/cldata/read_toolpath.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "postproc/cldata/interpreter.h"
#include "postproc/cldata/text.h"

namespace gouge {
namespace {

constexpr unsigned kNclHeaderClass = 7400;
constexpr std::size_t kUsualBytesOfLine = 32;

// NCL: the first record is a header of class 7400, written as 16-bit numbers, low byte first.
bool is_ncl_binary(std::string_view bytes) {
  if (bytes.size() < 8) return false;
  const unsigned low = static_cast<unsigned char>(bytes[2]);
  const unsigned high = static_cast<unsigned char>(bytes[3]);
  return low + 256 * high == kNclHeaderClass;
}

bool is_control(char c) {
  const unsigned byte = static_cast<unsigned char>(c);
  return (byte < 0x20 && c != '\n' && !is_blank(c)) || byte == 0x7f;
}

std::optional<Diagnostic> find_unreadable(const std::string& file, std::string_view bytes) {
  if (bytes.empty()) {
    return make_error("path-empty", "the file is empty; expected APT CL data or an NX CLSF", file);
  }
  if (is_ncl_binary(bytes)) {
    return make_error(
        "path-nccs-binary",
        "is a binary NCL file, which is not supported yet; export the CL data as ASCII (APT source)", file);
  }
  const auto control = std::find_if(bytes.begin(), bytes.end(), is_control);
  if (control == bytes.end()) return std::nullopt;
  const auto line = static_cast<std::size_t>(std::count(bytes.begin(), control, '\n')) + 1;
  return make_error("path-binary",
                    "is not text: byte " + std::to_string(static_cast<unsigned char>(*control)) +
                        " at position " + std::to_string(control - bytes.begin()) +
                        "; expected APT CL data or an NX CLSF",
                    file, line);
}

void note_unit(const UnitGuess& guess, Toolpath& path) {
  const std::string unit = guess.unit == LengthUnit::inch ? "inches" : "mm";
  if (guess.source == UnitGuess::Source::feed_word) {
    path.notes.push_back(make_note(
        "path-unit", "the file states no unit; taken as " + unit + " from the words of FEDRAT", path.file));
  } else if (guess.source == UnitGuess::Source::assumed) {
    path.notes.push_back(make_warning("path-unit", "the file states no unit; taken as mm", path.file));
  }
}

Diagnostic no_motion(const Toolpath& path) {
  std::string message = "holds no position; expected GOTO statements of APT CL data or an NX CLSF";
  if (!path.statements.empty()) {
    const SourceStatement& first = path.statements.front();
    const std::string_view all = path.source;
    message += "; the first line is " +
               quoted_text(all.substr(first.first_byte, first.last_byte - first.first_byte));
  }
  return make_error("path-no-motion", std::move(message), path.file);
}

}  // namespace

ReadOutcome read_toolpath(const std::string& file_name, std::string bytes) {
  ReadOutcome outcome;
  if (auto error = find_unreadable(file_name, bytes)) {
    outcome.errors.push_back(std::move(*error));
    return outcome;
  }
  Toolpath path;
  path.file = file_name;
  path.source = std::move(bytes);
  const Dialect dialect = recognise_dialect(path.source);
  const UnitGuess guess = find_unit(path.source);
  path.dialect = dialect.id;
  path.unit = guess.unit;
  path.is_unit_stated = guess.source == UnitGuess::Source::stated;

  path.statements.reserve(path.source.size() / kUsualBytesOfLine);
  path.moves.reserve(path.source.size() / kUsualBytesOfLine);
  Interpreter interpreter(path, dialect, guess.unit, nullptr);
  Lexer lexer(path.source);
  Statement statement;
  while (!interpreter.is_hopeless() && lexer.next(statement)) interpreter.take(statement);
  if (!interpreter.is_hopeless()) interpreter.finish();
  outcome.errors = interpreter.take_errors();
  if (outcome.errors.empty() && path.moves.empty()) outcome.errors.push_back(no_motion(path));
  if (!outcome.errors.empty()) return outcome;
  note_unit(guess, path);
  outcome.toolpath = std::move(path);
  return outcome;
}

}  // namespace gouge

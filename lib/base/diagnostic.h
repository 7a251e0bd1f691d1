#pragma once

#include <cstddef>
#include <string>
#include <vector>

// A message about input is one sentence. It states the location, what was found, what was expected and what to do.
// Wrong input gives data (a Diagnostic); an error of the program gives a failed assert.

namespace gouge {

enum class Severity { note, warning, error };

struct Diagnostic {
  Severity severity = Severity::error;
  std::string code;      ///< stable and kebab-case, for example "stl-truncated"; listed in docs/errors.md
  std::string file;      ///< as the user named it; empty when no file is concerned
  std::size_t line = 0;  ///< counted from 1; 0 when there is no line
  std::string message;   ///< found, expected, what to do; one line, no full stop at the end
};

using Diagnostics = std::vector<Diagnostic>;

[[nodiscard]] Diagnostic make_error(std::string code, std::string message, std::string file = {}, std::size_t line = 0);
[[nodiscard]] Diagnostic make_warning(std::string code, std::string message, std::string file = {},
                                      std::size_t line = 0);
[[nodiscard]] Diagnostic make_note(std::string code, std::string message, std::string file = {}, std::size_t line = 0);

[[nodiscard]] bool has_error(const Diagnostics& diagnostics);

/// Returns "file:line: error: message [code]", the form that compilers use, as one line without a line end. The
/// characters of the file name and of the message are made printable (printable_text.h).
[[nodiscard]] std::string to_text(const Diagnostic& diagnostic);

}  // namespace gouge

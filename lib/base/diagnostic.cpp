#include "lib/base/diagnostic.h"

#include <algorithm>
#include <array>
#include <utility>

#include "lib/base/printable_text.h"

namespace gouge {
namespace {

Diagnostic make(Severity severity, std::string&& code, std::string&& message, std::string&& file, std::size_t line) {
  return {severity, std::move(code), std::move(file), line, std::move(message)};
}

const char* word(Severity severity) {
  static constexpr std::array<const char*, 3> kNames = {"note", "warning", "error"};
  return kNames[static_cast<std::size_t>(severity)];
}

// Shortens long names: a name in a file may have a million letters, and the expected value is at the end of a message.
std::string shortened(std::string text) {
  constexpr std::size_t kMost = 3000, kBegin = 1500, kEnd = 1000;
  if (text.size() <= kMost) return text;
  const auto is_within_a_letter = [&](std::size_t at) {
    return (static_cast<unsigned char>(text[at]) & 0xc0U) == 0x80U;
  };
  std::size_t begin = kBegin, end = text.size() - kEnd;
  while (begin > 0 && is_within_a_letter(begin)) --begin;
  while (end < text.size() && is_within_a_letter(end)) ++end;
  return text.replace(begin, end - begin, " ... ");
}

}  // namespace

Diagnostic make_error(std::string code, std::string message, std::string file, std::size_t line) {
  return make(Severity::error, std::move(code), std::move(message), std::move(file), line);
}

Diagnostic make_warning(std::string code, std::string message, std::string file, std::size_t line) {
  return make(Severity::warning, std::move(code), std::move(message), std::move(file), line);
}

Diagnostic make_note(std::string code, std::string message, std::string file, std::size_t line) {
  return make(Severity::note, std::move(code), std::move(message), std::move(file), line);
}

bool has_error(const Diagnostics& diagnostics) {
  return std::any_of(diagnostics.begin(), diagnostics.end(),
                     [](const Diagnostic& d) { return d.severity == Severity::error; });
}

std::string to_text(const Diagnostic& diagnostic) {
  std::string text = diagnostic.file.empty() ? "gougecheck" : printable(diagnostic.file);
  if (diagnostic.line > 0) text += ":" + std::to_string(diagnostic.line);
  text += std::string(": ") + word(diagnostic.severity) + ": " + shortened(printable(diagnostic.message));
  if (!diagnostic.code.empty()) text += " [" + diagnostic.code + "]";
  return text;
}

}  // namespace gouge

#include "lib/base/paint.h"

#include <array>

#include "lib/base/printable_text.h"

namespace gouge {

std::string painted(std::string_view text, Paint paint, bool is_on) {
  if (!is_on || text.empty()) return std::string(text);
  // The codes are bold; bold red, magenta, cyan, green; faint. They are legible on light and on dark backgrounds.
  static constexpr std::array<const char*, 6> kCodes = {"1", "1;31", "1;35", "1;36", "1;32", "2"};
  return std::string("\x1b[") + kCodes[static_cast<std::size_t>(paint)] + "m" + std::string(text) + "\x1b[0m";
}

std::string painted_text(const Diagnostic& diagnostic) {
  static constexpr std::array<Paint, 3> kPaints = {Paint::note, Paint::warning, Paint::error};
  const std::string text = to_text(diagnostic);
  // The form is "PLACE: SEVERITY: MESSAGE [CODE]"; a place may itself contain ": ".
  const std::string code = diagnostic.code.empty() ? "" : " [" + diagnostic.code + "]";
  const std::string line = diagnostic.line > 0 ? ":" + std::to_string(diagnostic.line) : "";
  const std::string place = (diagnostic.file.empty() ? "gougecheck" : printable(diagnostic.file)) + line;
  const std::size_t severity = place.size() + 2, severity_end = text.find(' ', severity);
  return painted(text.substr(0, severity - 1), Paint::place, true) + " " +
         painted(text.substr(severity, severity_end - severity), kPaints[static_cast<std::size_t>(diagnostic.severity)],
                 true) +
         text.substr(severity_end, text.size() - code.size() - severity_end) + painted(code, Paint::faint, true);
}

}  // namespace gouge

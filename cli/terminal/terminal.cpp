#include "cli/terminal/terminal.h"

#include <unistd.h>

#include <cstdlib>
#include <iostream>
#include <string>

namespace gouge {
namespace {

int colour_slot() {
  static const int slot = std::ios_base::xalloc();
  return slot;
}

bool has_value(const char* name, std::string_view wanted = {}) {
  const char* value = std::getenv(name);
  return value != nullptr && *value != '\0' && (wanted.empty() || wanted == value);
}

}  // namespace

bool is_terminal(const std::ostream& stream) {
  if (&stream == &std::cout) return ::isatty(STDOUT_FILENO) == 1;
  return &stream == &std::cerr && ::isatty(STDERR_FILENO) == 1;
}

void choose_colour(std::ostream& stream, std::string_view word) {
  const bool is_automatic = is_terminal(stream) && !has_value("NO_COLOR") && !has_value("TERM", "dumb");
  stream.iword(colour_slot()) = word == "always" || (word != "never" && is_automatic) ? 1 : 0;
}

bool is_coloured(std::ostream& stream) { return stream.iword(colour_slot()) != 0; }

}  // namespace gouge

#include "cli/terminal/terminal.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>
#include <csignal>
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

std::size_t terminal_columns(const std::ostream& stream) {
  if (!is_terminal(stream)) return 0;
  winsize size{};
  const int handle = &stream == &std::cout ? STDOUT_FILENO : STDERR_FILENO;
  return ::ioctl(handle, TIOCGWINSZ, &size) == 0 ? size.ws_col : 0;
}

void choose_colour(std::ostream& stream, std::string_view word) {
  const bool is_automatic = is_terminal(stream) && !has_value("NO_COLOR") && !has_value("TERM", "dumb");
  stream.iword(colour_slot()) = word == "always" || (word != "never" && is_automatic) ? 1 : 0;
}

bool is_coloured(std::ostream& stream) { return stream.iword(colour_slot()) != 0; }

void prepare_standard_streams() {
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    // open() takes the lowest free number, which is that of the closed stream. The wrong mode makes every use of it
    // fail.
    if (::fcntl(stream, F_GETFD) < 0)
      static_cast<void>(::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY));
  }
}

bool is_reader_gone() {
  pollfd stream{STDOUT_FILENO, POLLOUT, 0};
  return ::poll(&stream, 1, 0) == 1 && (stream.revents & (POLLERR | POLLHUP)) != 0;
}

Diagnostic describe_failed_output() {
  return make_error("output-unwritable",
                    is_reader_gone() ? "standard output is a pipe whose reader ended before all was written"
                                     : "standard output could not be written (closed, full, or a limit of the shell)");
}

}  // namespace gouge

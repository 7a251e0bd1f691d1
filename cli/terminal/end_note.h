#pragma once

#include <string>

// Prints a note when a signal ends the program.

namespace gouge {

/// Text that the program prints on standard error if ctrl-C, SIGTERM or SIGHUP ends it while the object lives. At most one
/// object lives at a time.
class EndNote {
 public:
  explicit EndNote(std::string text);
  ~EndNote();
  EndNote(const EndNote&) = delete;
  EndNote& operator=(const EndNote&) = delete;

 private:
  std::string text_;
};

/// Prints the text of the EndNote that lives, if there is one. A signal handler may call it.
void print_end_note() noexcept;

}  // namespace gouge

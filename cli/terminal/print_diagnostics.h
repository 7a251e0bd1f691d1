#pragma once

#include <cstddef>
#include <iosfwd>
#include <optional>
#include <string>

#include "lib/base/diagnostic.h"

namespace CLI {
class App;
}

// Functions that print the messages of a command on standard error.

namespace gouge {

/// The options -q and -v of a command.
struct Verbosity {
  bool is_quiet = false;
  bool is_verbose = false;
};

/// Adds -q and -v; `on_verbose` and `on_quiet` are their help.
void add_verbosity(CLI::App& command, Verbosity& verbosity, const std::string& on_verbose,
                   const std::string& on_quiet = "Print no findings, only errors");

/// Returns the error that both are given (code usage), or nothing.
[[nodiscard]] std::optional<Diagnostic> find_contradiction(const Verbosity& verbosity);

/// Prints diagnostics, one in each line, in the format of compilers.
void print(std::ostream& err, const Diagnostics& diagnostics);

/// Prints warnings about the inputs; with -v also notes, with -q nothing. Of more than ten warnings it prints ten and the
/// number of the others. A list that grows can be printed in steps.
class NotePrinter {
 public:
  NotePrinter(std::ostream& err, const Verbosity& verbosity) : err_(err), verbosity_(verbosity) {}

  /// Prints what `notes` has gained since the last call. Requires that its beginning is as it was then.
  void print_new(const Diagnostics& notes);
  /// Prints the number of the warnings that were not printed.
  void print_rest();

 private:
  std::ostream& err_;
  Verbosity verbosity_;
  std::size_t seen_ = 0, warnings_ = 0;
};

/// Prints `notes` at once, as NotePrinter does.
void print_notes(std::ostream& err, const Diagnostics& notes, const Verbosity& verbosity);

/// Returns the maximum memory of this process so far, mapped files included; none if the system does not state it.
[[nodiscard]] std::optional<std::size_t> peak_memory_bytes();

/// Prints "memory: 178 MB at the peak", the maximum memory of this process so far, mapped files included. Prints
/// nothing if the system does not state it. It must not be part of a report, because it differs from run to run.
void print_peak_memory(std::ostream& err);

/// Prints `errors` and returns `status`.
int fail(std::ostream& err, const Diagnostics& errors, int status);

/// Returns the exit status for `errors`. If one of them has the code usage, it is that of a wrong command line, else that
/// of an input. An example of usage is a tool of --tool that the library lacks.
[[nodiscard]] int status_of(const Diagnostics& errors);

/// Prints `errors` and returns the status for them.
int fail(std::ostream& err, const Diagnostics& errors);

}  // namespace gouge

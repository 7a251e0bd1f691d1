#pragma once

#include <cstddef>
#include <iosfwd>
#include <optional>
#include <string>

#include "lib/base/diagnostic.h"

namespace CLI {
class App;
}

// Messages of a command on standard error.

namespace gouge {

/// -q and -v of a command.
struct Verbosity {
  bool is_quiet = false;
  bool is_verbose = false;
};

/// `on_verbose` is the help of -v.
void add_verbosity(CLI::App& command, Verbosity& verbosity, const std::string& on_verbose);

/// Returns the error that both are set (code usage), or nothing.
[[nodiscard]] std::optional<Diagnostic> find_contradiction(const Verbosity& verbosity);

/// Prints diagnostics, one a line, as compilers do.
void print(std::ostream& err, const Diagnostics& diagnostics);

/// Warnings of the inputs; with -v notes as well, with -q nothing. More than a handful are counted.
void print_notes(std::ostream& err, const Diagnostics& notes, const Verbosity& verbosity);

/// Returns the maximum memory of this process at any time, mapped files included; none where the system does not state
/// it.
[[nodiscard]] std::optional<std::size_t> peak_memory_bytes();

/// Prints "memory: 178 MB at the peak", the maximum memory of this process at any time, mapped files included. Prints
/// nothing where the system does not state it. For people, never for a report: it differs from run to run.
void print_peak_memory(std::ostream& err);

/// Prints `errors` and returns `status`.
int fail(std::ostream& err, const Diagnostics& errors, int status);

/// Does the same with the status of the error. It is that of the command line where one of them has the code usage, as
/// where --tool names a tool that the library lacks. Else it is that of an input.
int fail(std::ostream& err, const Diagnostics& errors);

}  // namespace gouge

#include "cli/terminal/print_diagnostics.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstddef>
#include <fstream>
#include <ostream>
#include <string>

#include "cli/terminal/listing_options.h"
#include "cli/terminal/terminal.h"
#include "lib/base/exit_code.h"
#include "lib/base/paint.h"
#include "lib/base/printable_text.h"

namespace gouge {
void add_verbosity(CLI::App& command, Verbosity& verbosity, const std::string& on_verbose,
                   const std::string& on_quiet) {
  command.add_flag("-q,--quiet", verbosity.is_quiet, on_quiet)->group(kTerminalGroup);
  command.add_flag("-v,--verbose", verbosity.is_verbose, on_verbose)->group(kTerminalGroup);
}

std::optional<Diagnostic> find_contradiction(const Verbosity& verbosity) {
  if (!verbosity.is_quiet || !verbosity.is_verbose) return std::nullopt;
  return make_error("usage", "-q and -v exclude each other; expected one of them");
}

void print(std::ostream& err, const Diagnostics& diagnostics) {
  constexpr std::size_t kIndent = 2;
  const std::size_t columns = terminal_columns(err);
  for (const Diagnostic& d : diagnostics) {
    const std::string text = is_coloured(err) ? painted_text(d) : to_text(d);
    err << (columns == 0 ? text : wrapped(text, columns, kIndent)) << "\n";
  }
}

namespace {

constexpr std::size_t kMaxWarnings = 10;

}  // namespace

void NotePrinter::print_new(const Diagnostics& notes) {
  for (; seen_ < notes.size(); ++seen_) {
    const Diagnostic& note = notes[seen_];
    if (verbosity_.is_quiet) continue;
    const bool is_shown = note.severity == Severity::warning && ++warnings_ <= kMaxWarnings;
    if (verbosity_.is_verbose || is_shown) print(err_, {note});
  }
}

void NotePrinter::print_rest() {
  if (verbosity_.is_verbose || warnings_ <= kMaxWarnings) return;
  err_ << "gougecheck: " << warnings_ - kMaxWarnings << " more warnings; -v shows all\n";
}

void print_notes(std::ostream& err, const Diagnostics& notes, const Verbosity& verbosity) {
  NotePrinter printer(err, verbosity);
  printer.print_new(notes);
  printer.print_rest();
}

// Does not use getrusage: its peak begins with that of the program which started this one.
std::optional<std::size_t> peak_memory_bytes() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.compare(0, 6, "VmHWM:") == 0) return 1024 * std::stoull(line.substr(6));
  }
  return std::nullopt;
}

void print_peak_memory(std::ostream& err) {
  constexpr std::size_t kMegabyte = 1000000;
  if (const auto bytes = peak_memory_bytes()) {
    err << "memory: " << (*bytes + kMegabyte - 1) / kMegabyte << " MB at the peak\n";
  }
}

int fail(std::ostream& err, const Diagnostics& errors, int status) {
  print(err, errors);
  return status;
}

int status_of(const Diagnostics& errors) {
  const bool is_usage = std::ranges::any_of(errors, [](const Diagnostic& d) { return d.code == "usage"; });
  return is_usage ? kExitUsage : kExitInput;
}

int fail(std::ostream& err, const Diagnostics& errors) { return fail(err, errors, status_of(errors)); }

}  // namespace gouge

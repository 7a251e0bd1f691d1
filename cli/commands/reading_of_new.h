#pragma once

#include "cli/commands/program_reading.h"
#include "lib/base/diagnostic.h"

namespace CLI {
class App;
}

// Options that hold for the new one of two toolpaths alone.

namespace gouge {

/// Adds the options of add_program_reading with the prefix --new-, for the new one of two toolpaths, in a group of their
/// own. Those without the prefix must be there.
void add_reading_of_new(CLI::App& command, ProgramReading& of_new);

/// Returns the facts of the new toolpath: those of `both`, each replaced where `of_new` states it. If `of_new` states a
/// machine or a control, the facts of machine and program in `both` are those of the old toolpath alone.
[[nodiscard]] ProgramReading reading_of_new(const ProgramReading& both, const ProgramReading& of_new);

/// Returns an error about the new toolpath with the options of add_reading_of_new in its message.
[[nodiscard]] Diagnostic with_options_of_new(Diagnostic error);

}  // namespace gouge

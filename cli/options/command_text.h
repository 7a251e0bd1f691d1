#pragma once

#include <string>

namespace CLI {
class App;
}

namespace gouge {

/// The command line of a parsed command as it can be typed again: its name, then what was given of its options in the
/// order of its help, quoted for a shell. Left out is what changes no result: outputs, threads, progress, how much is
/// printed, and the words of a report's head. So it is the same for one check however it was started.
[[nodiscard]] std::string repeatable_command(const CLI::App& command);

}  // namespace gouge

#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/number_text.h"

namespace CLI {
class FormatterBase;
}

namespace CLI {
class App;
}

namespace gouge {

/// Lays out --help in 80 columns, whatever the length of the texts.
[[nodiscard]] std::shared_ptr<CLI::FormatterBase> make_help_formatter();

/// Returns the command line of a parsed command as it can be typed again. It is the command's name, then the given
/// options in the order of its help, quoted for a shell. Options that change no result are left out: outputs, threads,
/// progress, how much is printed, and the words of a report's head. So it is the same for one check however it was
/// started.
[[nodiscard]] std::string repeatable_command(const CLI::App& command);
/// Returns a command line of these words, quoted for a shell where necessary.
[[nodiscard]] std::string repeatable_words(const std::string& command, const std::vector<std::string>& words);

}  // namespace gouge

#pragma once

#include <string>

#include "cli/options/command_doc.h"

namespace gouge {

/// Returns the script that completes command lines of `program` in `shell`, which is bash, zsh or fish. It completes
/// commands, options, files, folders, and values of options with a fixed list of values.
[[nodiscard]] std::string write_completion(const std::string& shell, const CommandDoc& program);

[[nodiscard]] std::string bash_completion(const CommandDoc& program);
[[nodiscard]] std::string zsh_completion(const CommandDoc& program);
[[nodiscard]] std::string fish_completion(const CommandDoc& program);

/// Kind of value that is completed after an option, or for a positional.
enum class Completed { nothing, files, folders, choices, commands };
[[nodiscard]] Completed completed_of(const OptionDoc& option);

/// Returns `program` and all commands below it, each before its own subcommands.
[[nodiscard]] std::vector<const CommandDoc*> flattened(const CommandDoc& program);

/// Returns `text` as one word of a shell, in single quotes.
[[nodiscard]] std::string single_quoted(const std::string& text);

/// Returns the beginning of a description for a menu: up to its first clause, at most 72 characters.
[[nodiscard]] std::string brief_of(const std::string& description);

}  // namespace gouge

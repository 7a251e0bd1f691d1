#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/machine/program_facts.h"
#include "cli/options/option_table.h"
#include "lib/base/files.h"
#include "lib/base/result.h"
#include "postproc/formats/read_toolpath.h"

namespace gouge {

/// Options for reading a toolpath, as typed. Empty: as the file states.
struct ReadingArguments : StatedProgram {
  std::string dialect, units, cutcom;
  std::vector<std::string> harmless_words;
  std::string retract_plane;
};

[[nodiscard]] const OptionRows<ReadingArguments>& reading_options();

/// Returns the given options, "--offset", that say nothing about the toolpath. These are the facts about programs for CL
/// data, and for a program those about CL data.
[[nodiscard]] std::vector<std::string> options_without_effect(const ReadingArguments& arguments, bool is_program);

/// Errors (code usage): a retract plane that is not a length, or an unknown dialect. Also a harmless word that is not a
/// word, or that is read.
[[nodiscard]] Result<ReadOptions> understand(const ReadingArguments& arguments);

/// Reads the file of --tool-lengths into the set-up of the program. Nothing is read if none is given.
/// Returns the first error. `bytes`: takes the text that was read.
[[nodiscard]] std::optional<Diagnostic> read_tool_lengths(const ReadingArguments& arguments, std::uint64_t max_bytes,
                                                          ReadOptions& options, std::string& bytes);

/// --max-input of a command, in bytes: no file it reads may have more.
struct InputLimit {
  std::uint64_t max_bytes = kMaxInputBytes;
};

/// The parser refuses what is not a size, so that `limit` is always usable.
void add_input_limit(CLI::App& command, InputLimit& limit);

}  // namespace gouge

#pragma once

#include <string>
#include <string_view>

#include "cli/options/reading_options.h"
#include "lib/machine/machine.h"

namespace gouge {

/// Reads --machine: a machine file, or preset:NAME. Errors: usage, for a preset that does not exist; those of read_file
/// and read_machine. `bytes`: takes the text that was read.
[[nodiscard]] Result<Machine> load_machine(const std::string& typed, const InputLimit& limit, std::string& bytes);

/// Begins a --machine that is no file.
inline constexpr std::string_view kMachinePreset = "preset:";

/// Help of --machine.
inline constexpr const char* kMachineHelp =
    "Machine file, configuration of LinuxCNC (INI), or preset:NAME ('gougecheck machine list'): its rotary joints and the laws of its control";

}  // namespace gouge

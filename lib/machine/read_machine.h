#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lib/machine/machine.h"

namespace gouge {

/// Reads a machine file (docs/formats/machine.md). `file` is for messages.
/// Errors, with the line: machine-syntax, machine-duplicate-key, json-too-deep, json-too-long; machine-field (a key
/// that is missing, unknown or not as expected); machine-joints as of make_machine.
[[nodiscard]] Result<Machine> read_machine(const std::string& file, std::string_view bytes);

/// A machine that the program knows, as the text of a machine file.
struct MachinePreset {
  std::string_view name, title, text;
};
[[nodiscard]] const std::vector<MachinePreset>& machine_presets();
/// Returns the preset of this name; null where there is none.
[[nodiscard]] const MachinePreset* find_preset(std::string_view name);

}  // namespace gouge

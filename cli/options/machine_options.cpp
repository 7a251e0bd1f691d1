#include "cli/options/machine_options.h"

#include <string_view>

#include "cli/terminal/length_text.h"
#include "lib/base/files.h"
#include "lib/machine/linuxcnc_ini.h"
#include "lib/machine/read_machine.h"

namespace gouge {

Result<Machine> load_machine(const std::string& typed, const InputLimit& limit, std::string& bytes) {
  if (typed.starts_with(kMachinePreset)) {
    const MachinePreset* const preset = find_preset(std::string_view(typed).substr(kMachinePreset.size()));
    if (preset == nullptr) {
      std::string names;
      for (const MachinePreset& one : machine_presets()) names += (names.empty() ? "" : ", ") + std::string(one.name);
      return usage_error("--machine", typed, "a machine file, or preset: and one of " + names);
    }
    bytes = preset->text;
    return read_machine(typed, bytes);
  }
  Result<std::string> read = read_file(typed, limit.max_bytes);
  if (!read) return read.error();
  bytes = std::move(*read);
  return is_linuxcnc_ini(bytes) ? read_linuxcnc_ini(typed, bytes) : read_machine(typed, bytes);
}

}  // namespace gouge

#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "postproc/gcode/running/program_setup.h"

namespace gouge {

/// Receives the name and the text of a file that was read.
using FileReceiver = std::function<void(const std::string& file, const std::string& bytes)>;

/// Returns the set-up of a program with the programs beside its file. O77 means each file of that number, with zeros and
/// an ending such as .nc or none: o00077.NC. Another name means the file of this name, with such an ending or none.
/// `on_read` may be empty.
[[nodiscard]] std::shared_ptr<const ProgramSetup> with_files_beside(const std::shared_ptr<const ProgramSetup>& setup,
                                                                    const std::string& path_file,
                                                                    std::uint64_t max_bytes, FileReceiver on_read);

}  // namespace gouge
